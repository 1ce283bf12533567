#pragma once

#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <span>

namespace blossom {

/// The spline over given knots that has given values at nodes, as many as there are control points; where a
/// node occurs k times before, the value is that of the derivative of order k, on the segment to the right of
/// the node, at the end of the domain on the last.
///
/// There is exactly one for all values if and only if, with the nodes in increasing order, node i lies inside
/// the support of the B-spline i, or at its end where the derivative of that order of this B-spline is not 0.
/// Row i of the system of equations has n + 1 entries, all else is 0; Bareiss's elimination of a band needs
/// no pivots, as the matrix is totally positive. Cost for m points: m n^2 / 2 combinations of integers, and m
/// n products a coordinate, of as many bits as the determinant. Errors: `wrong_arity` for another number of
/// nodes; `outside_domain` at `Part::nodes / i`; `missing_sample` at `Part::nodes` if the condition fails,
/// naming the B-spline; those of `data_in_order`; `limit_exceeded`. Source: Schoenberg and Whitney, "On Polya
/// frequency functions III", 1953; Karlin and Ziegler, "Chebyshevian spline functions", 1966.
BSplineCurve interpolate(const KnotVector& knots, std::span<const Rational> nodes,
                         std::span<const Coordinates> values, const Limits& limits = {});

}  // namespace blossom
