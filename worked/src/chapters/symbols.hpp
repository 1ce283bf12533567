#pragma once

#include <blossom/core/algebra/sparse_polynomial.hpp>
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

}  // namespace blossom::worked
