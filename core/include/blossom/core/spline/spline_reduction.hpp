#pragma once

#include <blossom/core/curve/degree_reduction.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>

namespace blossom {

struct SplineReduction {
    BSplineCurve curve;
    /// Whether `curve` is the same map.
    bool exact = true;
    /// The integral of |P - Q|^2 over the domain, summed over the coordinates.
    Rational l2_squared;
    /// For `uniform`, the maximum of |P - Q| over the domain in each coordinate; otherwise empty.
    Coordinates maximum;
};

/// An approximation of a spline by one of degree m <= n: each segment is reduced over its span, and the
/// results are joined.
///
/// With r = n - m, a knot of the domain loses r copies, but keeps as many as the contact of the reduced
/// segments requires: with `inverse_formula` and `least_squares_endpoints` the result is continuous where the
/// curve is, with the other methods it may jump. Therefore it inverts `elevate` by r exactly. The knots
/// outside the domain are kept if possible; otherwise the end is repeated as often as the convention permits.
/// Degree 0 is always textbook. Cost: `reduce` and a joint per segment. Errors: those of `reduce` and `join`.
SplineReduction reduce(const BSplineCurve& curve, std::size_t m, ReductionMethod method,
                       const Limits& limits = {});

}  // namespace blossom
