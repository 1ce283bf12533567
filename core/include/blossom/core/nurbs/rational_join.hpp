#pragma once

#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <span>
#include <vector>

namespace blossom {

/// Curves of homogeneous points (w P, w) as one rational B-spline, see `join`: curve i by its pieces
/// `maps[i]`.
///
/// A rational curve is the same when its homogeneous points are multiplied by a number. Each piece is scaled
/// so that it meets the one before it with the greatest order, beginning with the first, whose weights stay.
/// Where neighbours are one rational curve but have different factors in common to all their coordinates,
/// these are divided out, so that no knot stands between them. Knots have multiplicity n - k where the
/// homogeneous points meet with order k, which may be less than the order of the rational curves.
///
/// Cost besides: two contacts a joint, and greatest common divisors of polynomials. Errors: those of `join`.
BSplineCurve rational_join(std::span<const std::vector<BezierCurve>> maps, const Limits& limits = {});

/// The same over given knots. Errors besides: those of `join` over knots; `zero_weight` where a weight
/// vanishes at a knot that needs a higher order.
BSplineCurve rational_join(std::span<const std::vector<BezierCurve>> maps, const KnotVector& knots,
                           const Limits& limits = {});

/// The same of curves side by side, see `join_rows`.
BSplineCurve rational_join_rows(std::span<const std::vector<BezierCurve>> maps, std::size_t rows,
                                const KnotVector& knots, const Limits& limits = {});

}  // namespace blossom
