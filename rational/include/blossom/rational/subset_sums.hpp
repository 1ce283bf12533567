#pragma once

#include <blossom/rational/integer.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace blossom {

/// `multiplicity` equal arguments (u, mass): the point u / mass, or the vector u if the mass is 0.
struct SubsetGroup {
    Integer u;
    Integer mass;
    std::size_t multiplicity;
};

/// n! p(arguments) for each row c_0, ..., c_n of `rows`, where p is the blossom of sum_k c_k t^k, linear in
/// each pair (u, mass), at the n arguments of `groups`. It is computed as the product of all nonzero masses
/// times the polarization sum at the points u / mass and the vectors u,
///
///     sum over sub-multisets S of (-1)^(n-|S|) prod C(m_i, j_i) F(sum of S, number of points in S),
///     F(u, v) = sum_k c_k u^k v^(n-k).
///
/// Every term is evaluated. Returns nullopt for results beyond 100,000 bits, for which integers are faster.
/// Cost: prod(m_i + 1) values of a polynomial of degree n modulo each of as many primes as the result needs.
/// Source: Fernandez-Jambrina, equation (20). Statement: fj-cor1.
std::optional<std::vector<Integer>> strict_subset_sums(std::span<const std::span<const Integer>> rows,
                                                       std::span<const SubsetGroup> groups);

/// The same numbers, with the terms of equal numbers of points combined: only their power sums sum_S
/// (-1)^(n-|S|) (sum of S)^k are formed, one argument after the other.
///
/// Cost: n^4 / 4 multiply-adds modulo as many primes as the result needs. Returns nullopt for results beyond
/// a million bits, for n > 4095, and if one of these primes divides a mass.
std::optional<std::vector<Integer>> regrouped_subset_sums(std::span<const std::span<const Integer>> rows,
                                                          std::span<const SubsetGroup> groups);

}  // namespace blossom
