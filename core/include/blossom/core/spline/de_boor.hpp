#pragma once

#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/core/spline/progressive.hpp>

namespace blossom {

/// The polynomial on a non-empty span, by its control points over the 2n knots around the span.
/// Errors: `outside_domain`. Source: DeRose, section 4.6. Statements: derose-46-next-segment,
/// hart-four-points.
ProgressiveCurve segment(const BSplineCurve& curve, std::size_t span);

/// The only non-empty span. Errors: `outside_domain`, which lists the spans, if there are several.
std::size_t only_span(const KnotVector& knots);

/// The blossom of the polynomial on a span at any arguments: points, vectors or pairs, which may lie outside
/// the span.
///
/// The whole spline has no blossom: at arguments that are not consecutive knots, its segments have different
/// values (see derose-46-piecewise-blossom). Cost: n^2 / 2 combinations of points. Errors: `wrong_arity`,
/// `outside_domain`, `limit_exceeded`. Source: DeRose, figure 10, corrected. Statements: derose-fig10,
/// fj-bspline-same-segment.
Coordinates segment_blossom(const BSplineCurve& curve, std::size_t span, std::span<const Argument> arguments,
                            const Limits& limits = {});

/// F(t) = f(t, ..., t) by de Boor's algorithm, on the segment to the right of t; at the end of the domain, on
/// the last segment.
///
/// Cost: a bisection, and n^2 / 2 combinations of points on integers. Errors: `outside_domain`,
/// `limit_exceeded`. Source: DeRose, section 4.6; Hart, "De Boor". Statements: derose-46-deboor, hart-deboor.
Coordinates de_boor(const BSplineCurve& curve, const Parameter& t, const Limits& limits = {});

/// `de_boor` under the name that all kinds of curves share.
inline Coordinates evaluate(const BSplineCurve& curve, const Parameter& t, const Limits& limits = {}) {
    return de_boor(curve, t, limits);
}

/// F^(k)(t) = n!/(n-k)! f(t^(n-k), delta^k) on the segment that `de_boor` uses; zero for k > n.
/// Cost: one blossom value. Errors: `outside_domain`, `limit_exceeded`.
/// Source: Goldman, theorem 9. Statement: goldman-thm9.
Coordinates derivative(const BSplineCurve& curve, std::size_t order, const Parameter& t,
                       const Limits& limits = {});

/// The derivative of order k as a B-spline of degree n - k, or zero of degree 0 for k > n.
///
/// One step: Q_j = n (P_(j+1) - P_j) / (t_(j+n) - t_j) = n f(delta, t_(j+1), ..., t_(j+n-1)), over the knots
/// without the first and the last. Where the curve jumps, at a knot of multiplicity n + 1, this multiplicity
/// is also reduced by one. The convention is kept, except that degree 0 is always textbook. Cost: k passes
/// over the points. Errors: `limit_exceeded`.
BSplineCurve derivative_curve(const BSplineCurve& curve, std::size_t order, const Limits& limits = {});

}  // namespace blossom
