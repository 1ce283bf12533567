#pragma once

#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/core/maps/polynomial_curve.hpp>
#include <blossom/rational/limits.hpp>

namespace blossom {

/// The form of the points of a map.
enum class GraphForm {
    points,       ///< the coordinates of P(t)
    homogeneous,  ///< (w P(t), w), with the weight last
};

/// The curve (t, P(t)), with an additional first coordinate.
///
/// The blossom of t is the mean of its arguments. Therefore this coordinate of a control point is the mean of
/// the arguments at which the point is the blossom value: (a (n - k) + b k) / n for a Bezier curve, the
/// Greville abscissa for a B-spline. With weights the coordinate is t w(t), whose degree is one higher than
/// that of w. If the degree of the map is too low for this coordinate, it is first raised by one. Cost: O(n)
/// additions, with weights those of raising the degree. Errors: `limit_exceeded`. Source: Goldman, exercise
/// 9. Statement: goldman-ex-9.
PolynomialCurve graph(const PolynomialCurve& curve, GraphForm form = GraphForm::points,
                      const Limits& limits = {});
BezierCurve graph(const BezierCurve& curve, GraphForm form = GraphForm::points, const Limits& limits = {});
BSplineCurve graph(const BSplineCurve& curve, GraphForm form = GraphForm::points, const Limits& limits = {});

}  // namespace blossom
