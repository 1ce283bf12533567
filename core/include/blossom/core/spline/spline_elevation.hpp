#pragma once

#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>

namespace blossom {

/// The same curve with degree n + r: the multiplicity of each distinct knot of the domain grows by r, which
/// keeps the order of contact there. Each control point is the mean, over the n-subsets of its window of n +
/// r new knots, of the blossom of a segment.
///
/// The mean is computed by raising each segment in Bezier form. Cost for m points: O(m n^3 + m (n + r)^2)
/// operations; each non-empty span adds r points. Errors: `limit_exceeded`. Source: DeRose, section 4.4.
/// Statement: derose-raise-general.
BSplineCurve elevate(const BSplineCurve& curve, std::size_t r, const Limits& limits = {});

}  // namespace blossom
