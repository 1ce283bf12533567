#pragma once

#include <blossom/rational/integer.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace blossom {

/// `multiplicity` equal arguments (u, mass): the point u / mass, or the vector u where the mass is 0.
struct SubsetGroup {
    Integer u;
    Integer mass;
    std::size_t multiplicity;
};

/// n! p(arguments) prod |mass| signs for each row c_0, ..., c_n of `rows`, where p is the blossom of
/// sum_k c_k t^k and the arguments are those of `groups`, n in all: the numerators of the polarization sum
///
///     sum over sub-multisets S of (-1)^(n-|S|) prod C(m_i, j_i) F(sum of S, number of points in S),
///     F(u, v) = sum_k c_k u^k v^(n-k),
///
/// times the product of all masses but 0. Every term is evaluated.
///
/// Cost: prod(m_i + 1) values of a polynomial of degree n modulo each of as many primes as the result needs.
std::vector<Integer> strict_subset_sums(std::span<const std::span<const Integer>> rows,
                                        std::span<const SubsetGroup> groups);

/// The same numbers with the terms of equal numbers of points taken together: only their power sums
/// sum_S (-1)^(n-|S|) (sum of S)^k are formed, argument by argument.
///
/// Cost: n^4 / 4 multiply-adds modulo as many primes as the result needs. Nothing where one of these primes
/// divides a mass.
std::optional<std::vector<Integer>> regrouped_subset_sums(std::span<const std::span<const Integer>> rows,
                                                          std::span<const SubsetGroup> groups);

}  // namespace blossom
