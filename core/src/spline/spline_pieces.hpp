#pragma once

// From polynomial pieces to the control points of a spline.

#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <span>
#include <vector>

namespace blossom {

/// The spline over `knots` whose polynomials are `pieces`, which have the degree of the knots and are over
/// adjacent increasing intervals that make up the domain. Control point j is the blossom value at its window
/// of any piece on which it has influence; the caller guarantees that these values agree.
BSplineCurve spline_of_pieces(KnotVector knots, std::span<const BezierCurve> pieces, const Limits& limits);

}  // namespace blossom
