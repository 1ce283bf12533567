#pragma once

#include <blossom/core/curve/roots.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <utility>
#include <vector>

namespace blossom {

/// Where a scalar spline is zero.
struct SplineRoots {
    /// In rising order, without those in an interval of `zeros`.
    std::vector<Root> roots;
    /// The intervals between whose ends the spline is zero, in rising order; a single point where only the
    /// end of the range belongs to such a segment.
    std::vector<std::pair<Rational, Rational>> zeros;
};

/// The zeros of a spline with one coordinate, or with the two of (P, w), in the part of the range that
/// belongs to its domain. A parameter where segments meet belongs to the segment on its right, as in
/// `de_boor`; so does the multiplicity of a root there.
///
/// Cost: `roots` a segment. Errors: those of `numerator` and `roots`; `limit_exceeded`.
SplineRoots roots(const BSplineCurve& curve, const ParameterRange& range, const Rational& width = 0,
                  const Limits& limits = {});

}  // namespace blossom
