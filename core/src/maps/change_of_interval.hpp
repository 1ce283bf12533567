#pragma once

// Substitution of a line into a polynomial: a Taylor shift by one between two scalings.

#include <blossom/core/constructions/constructions.hpp>
#include <blossom/core/maps/interval.hpp>

#include <span>

namespace blossom {

/// m_k with sum_k c_k t^k = sum_k m_k (t - center)^k.
/// Cost: one Taylor shift by one, and 4 n products and exact divisions of numbers of the size of the result.
Quotients<Integer> taylor_coefficients(std::span<const Integer> coefficients, const Rational& center);

/// The Bernstein coefficients over an interval, as `constructions::bernstein_from_monomial` gives them: in s
/// = x / (x + y), the coefficients of x^k y^(n-k) are those of the reversed polynomial in s, shifted by one.
/// Cost: two Taylor shifts by one, and 6 n products and exact divisions of numbers of the size of the result.
Quotients<Integer> bernstein_from_monomial(std::span<const Integer> coefficients, const Interval& interval);

}  // namespace blossom
