#pragma once

#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/core/maps/polynomial_curve.hpp>
#include <blossom/rational/limits.hpp>

namespace blossom {

/// What the points of a map are.
enum class GraphForm {
    points,       ///< the coordinates of P(t)
    homogeneous,  ///< (w P(t), w), the weight last
};

/// The curve (t, P(t)), with one coordinate more in front.
///
/// The blossom of t is the mean of its arguments, so that this coordinate of a control point is the mean of
/// the arguments at which it is the blossom value: (a (n - k) + b k) / n for a Bezier curve, the Greville
/// abscissa for a B-spline. With weights the coordinate is t w(t), of one degree more than w. A map whose
/// degree has no room for it is raised by one degree first. Cost: O(n) additions, with weights those of
/// raising the degree. Errors: `limit_exceeded`. Source: Goldman, exercise 9. Statement: goldman-ex-9.
PolynomialCurve graph(const PolynomialCurve& curve, GraphForm form = GraphForm::points,
                      const Limits& limits = {});
BezierCurve graph(const BezierCurve& curve, GraphForm form = GraphForm::points, const Limits& limits = {});
BSplineCurve graph(const BSplineCurve& curve, GraphForm form = GraphForm::points, const Limits& limits = {});

}  // namespace blossom
