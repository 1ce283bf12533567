#pragma once

#include <blossom/core/algebra/sparse_polynomial.hpp>
#include <blossom/core/maps/argument.hpp>
#include <blossom/worked/formula.hpp>

#include <span>
#include <string>
#include <vector>

namespace blossom::worked {

/// u1, ..., un as symbols.
std::vector<Formula> numbered_symbols(const std::string& letter, std::size_t n);

/// A polynomial in several variables: variable i is written as symbols[i]. Terms stand in the order of their
/// degree in the first `counted` variables.
Formula sparse_formula(const SparsePolynomial& polynomial, std::span<const Formula> symbols,
                       std::size_t counted);

/// e_0, ..., e_n of homogeneous arguments: the coefficients of prod (mass_i + u_i X).
std::vector<Rational> elementary_values(std::span<const Argument> arguments);

/// The subsets of {0, ..., n - 1} with k elements, in lexicographic order. Cost: C(n, k) lists.
std::vector<std::vector<std::size_t>> subsets_of_size(std::size_t n, std::size_t k);

}  // namespace blossom::worked
