#pragma once

#include <blossom/core/curve/roots.hpp>
#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace blossom {

/// Where a scalar spline is zero.
struct SplineRoots {
    /// In rising order, without those in an interval of `zeros`.
    std::vector<Root> roots;
    /// The intervals between whose ends the spline is zero, in rising order; a single point where only the
    /// end of the range belongs to such a segment.
    std::vector<ParameterRange> zeros;
};

/// A polynomial in a range of its parameter, of which the upper end may belong to the next piece.
struct RangedPolynomial {
    Polynomial polynomial;
    ParameterRange range;
    bool closed = true;
};

/// The zeros of adjacent pieces in rising order. Where the range of a piece is a single point, this is a root
/// or a zero of the whole piece. Cost: `roots` a piece. Errors: `limit_exceeded`.
SplineRoots roots(std::span<const RangedPolynomial> pieces, const Rational& width = 0,
                  const Limits& limits = {});

/// The parts of the segments of a spline in a range, in rising order: `use(segment, range, closed)` for each
/// part that is not empty. A parameter where segments meet belongs to the segment on its right, as in
/// `de_boor`. Cost: that of `bezier_segments`.
void for_each_segment(
    const BSplineCurve& curve, const ParameterRange& range, const Limits& limits,
    const std::function<void(const BezierCurve& segment, const ParameterRange& range, bool closed)>& use);

/// The zeros of a spline with one coordinate, or with the two of (P, w), in the part of the range that
/// belongs to its domain. A parameter where segments meet belongs to the segment on its right; so does the
/// multiplicity of a root there.
///
/// Cost: `roots` a segment. Errors: those of `numerator` and `roots`; `limit_exceeded`.
SplineRoots roots(const BSplineCurve& curve, const ParameterRange& range, const Rational& width = 0,
                  const Limits& limits = {});

}  // namespace blossom
