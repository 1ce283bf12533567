#pragma once

#include <blossom/core/curve/degree_reduction.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>

namespace blossom {

struct SplineReduction {
    BSplineCurve curve;
    /// Whether nothing was lost: `curve` is the same map.
    bool exact = true;
    /// The integral of |P - Q|^2 over the domain, summed over the coordinates.
    Rational l2_squared;
    /// For `uniform`, the maximum of |P - Q| over the domain in each coordinate; empty for the others.
    Coordinates maximum;
};

/// A spline by one of degree m <= n: each segment by itself is reduced over its span, and they are joined.
///
/// With r = n - m, a knot of the domain loses r of its copies, but keeps as many as the contact of the
/// reduced segments needs: `inverse_formula` and `least_squares_endpoints` stay continuous where the curve
/// is, the other methods may jump. So it undoes `elevate` by r exactly. At the ends the knots outside the
/// domain are kept where that is possible, otherwise the end is repeated as often as the convention has room
/// for; degree 0 is always textbook. Cost: `reduce` and a joint a segment. Errors: those of `reduce` and
/// `join`.
SplineReduction reduce(const BSplineCurve& curve, std::size_t m, ReductionMethod method,
                       const Limits& limits = {});

}  // namespace blossom
