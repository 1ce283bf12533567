#pragma once

#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>

namespace blossom {

/// The same curve with degree n + r: each distinct knot of the domain is repeated r times more, which keeps
/// the order of contact there, and each control point is the mean over the n-subsets of its window of n + r
/// new knots of the blossom of a segment.
///
/// The mean is taken by raising each segment in Bezier form. Cost for m points: O(m n^3 + m (n + r)^2)
/// operations; there are r more points for each non-empty span. Errors: `limit_exceeded`. Source: DeRose,
/// section 4.4. Statement: derose-raise-general.
BSplineCurve elevate(const BSplineCurve& curve, std::size_t r, const Limits& limits = {});

}  // namespace blossom
