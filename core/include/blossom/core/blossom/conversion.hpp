#pragma once

#include <blossom/core/maps/polynomial_map.hpp>
#include <blossom/rational/limits.hpp>

namespace blossom {

/// The control polygon of `curve` over [a, b]: P_k = p(a^(n-k), b^k), the dual functional property.
///
/// The interval may be reversed. Cost: O(n^2) multiply-adds on integers of O(n h) bits, h the bits of a, b
/// and the coefficients. Errors: `limit_exceeded`. Source: Goldman, theorem 4, by the triangle of figure
/// 11(b). Statements: goldman-thm4, goldman-dual-functional.
BezierCurve control_points(const PolynomialCurve& curve, const Interval& interval, const Limits& limits = {});

/// The control polygon over another interval, P_k = p(c^(n-k), d^k), by the triangles of figures 11(a) and
/// 11(b). Cost: O(n^2) multiply-adds. Errors: `limit_exceeded`. Source: DeRose, section 4.2. Statements:
/// derose-42-vi-st, blog-subcurve.
BezierCurve control_points(const BezierCurve& curve, const Interval& interval, const Limits& limits = {});

/// The n + 1 monomial coefficients, a_k = C(n, k) p(0^(n-k), delta^k); the formal degree is kept.
///
/// Cost: O(n^2) multiply-adds. Errors: `limit_exceeded`.
/// Source: Goldman, equation (4.4), by the triangle of figure 11(a). Statements: goldman-eq44,
/// goldman-fig11a.
PolynomialCurve monomial_form(const BezierCurve& curve, const Limits& limits = {});

/// The same for a map in either representation.
BezierCurve control_points(const PolynomialMap& map, const Interval& interval, const Limits& limits = {});
PolynomialCurve monomial_form(const PolynomialMap& map, const Limits& limits = {});

}  // namespace blossom
