#pragma once

#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/polynomial_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>

namespace blossom {

/// The same map with formal degree n + r: the blossom q~(u_1..u_{n+r}) is the mean of q over the n-subsets of
/// arguments, so that the control points become P~_i = sum_j C(n, j) C(r, i - j) / C(n + r, i) P_j.
///
/// Cost: n r multiply-adds a coordinate. Errors: `limit_exceeded` when n + r exceeds the degree.
/// Source: DeRose, section 4.4; Goldman, exercise 12. Statements: derose-raise-general, goldman-ex-12b.
BezierCurve elevate(const BezierCurve& curve, std::size_t r, const Limits& limits = {});

/// The same coefficients, with zeros for t^(n+1), ..., t^(n+r).
PolynomialCurve elevate(const PolynomialCurve& curve, std::size_t r, const Limits& limits = {});

}  // namespace blossom
