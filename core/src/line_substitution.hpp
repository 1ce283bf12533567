#pragma once

// Substitution of a line into a polynomial as a Taylor shift by one between two scalings.

#include <blossom/core/constructions.hpp>

#include <span>
#include <vector>

namespace blossom {

/// 1, base, ..., base^n.
std::vector<Integer> powers(const Integer& base, std::size_t n);

/// The coefficients of sum_k c_k (a + d X)^k q^(n-k), as `constructions::substitute_line` gives them.
/// Cost: one Taylor shift by one, and n products and exact divisions of numbers of the size of the result.
std::vector<Integer> substitute_line(std::span<const Integer> coefficients, const Integer& a,
                                     const Integer& d, const Integer& q);

/// The Bernstein coefficients over [a/q, b/q], as `constructions::bernstein_from_monomial` gives them: the
/// coefficients of x^k y^(n-k) for s = x / (x + y) are those of the reversed polynomial, shifted by one.
/// Cost: two Taylor shifts by one, and 3 n products of numbers of the size of the result.
Quotients<Integer> bernstein_from_monomial(std::span<const Integer> coefficients, const Integer& a,
                                           const Integer& b, const Integer& q);

}  // namespace blossom
