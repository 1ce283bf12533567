#pragma once

// Substitution of a line into a polynomial as a Taylor shift by one between two scalings.

#include <blossom/rational/integer.hpp>

#include <span>
#include <vector>

namespace blossom {

/// 1, base, ..., base^n.
std::vector<Integer> powers(const Integer& base, std::size_t n);

/// The coefficients of sum_k c_k (a + d X)^k q^(n-k), as `constructions::substitute_line` gives them.
/// Cost: one Taylor shift by one, and n products and exact divisions of numbers of the size of the result.
std::vector<Integer> substitute_line(std::span<const Integer> coefficients, const Integer& a,
                                     const Integer& d, const Integer& q);

}  // namespace blossom
