#pragma once

#include <blossom/core/maps/polynomial_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <span>

namespace blossom {

/// The coefficients c_k of P(t) = sum_k c_k (t - x_0) ... (t - x_(k-1)), k = 0..n, for nodes x_0, x_1, ... in
/// any order, of which the first n count: the divided differences [x_0, ..., x_k] P, each the sum of
/// p(x_0^(i_0), ..., x_k^(i_k), delta^k) over all i with the sum n - k.
///
/// By synthetic division by one factor after the other. Cost: n^2 / 2 multiply-adds a coordinate. Errors:
/// `wrong_arity` for fewer than n nodes; `limit_exceeded`.
PointArray newton_form(const PolynomialCurve& curve, std::span<const Rational> nodes,
                       const Limits& limits = {});

/// The polynomial with these coefficients, by Horner's rule; the inverse of `newton_form`. Cost, errors: as
/// there.
PolynomialCurve monomial_form_of_newton(const PointArray& coefficients, std::span<const Rational> nodes,
                                        const Limits& limits = {});

/// Errors: `wrong_arity`, at `Part::nodes / i`, for a node that occurs before.
void require_distinct(std::span<const Rational> nodes);

/// The Lagrange polynomials of distinct nodes x_0, ..., x_n as the coordinates of one curve: coordinate i is
/// 1 at x_i and 0 at the others.
///
/// The product of all t - x_j, divided by one of them. Cost: n^2 multiply-adds and products. Errors: those of
/// `require_distinct`; `wrong_arity` for no node; `limit_exceeded`.
PolynomialCurve lagrange_polynomials(std::span<const Rational> nodes, const Limits& limits = {});

}  // namespace blossom
