#pragma once

#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/core/spline/continuity.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <utility>

namespace blossom {

// A closed curve over [a, b] ends where it begins; there is its seam. With the period b - a it goes on behind
// b as it does behind a.

/// The last segment, and the first one moved behind it, which meet at the seam b.
std::pair<BezierCurve, BezierCurve> sides_of_seam(const BSplineCurve& curve, const Limits& limits = {});

/// The contact at the seam: order -1 unless the curve is closed. Errors: `limit_exceeded`.
/// Source: DeRose, theorem 2. Statement: derose-thm2.
Contact seam_contact(const BSplineCurve& curve, const Limits& limits = {});

/// The same curve over knots that repeat with the period: the seam is a knot m times, the knots before and
/// behind the domain are those at its other end, and the last n + 1 - m control points are the first ones
/// again where the order of contact at the seam is n - m or more. The convention is kept.
///
/// Control points are blossom values at windows of the new knots. Cost for p points: O(p) blossom values.
/// Errors: `bad_knots` unless 1 <= m <= n, or m = 1 for degree 0; `limit_exceeded`.
BSplineCurve over_periodic_knots(const BSplineCurve& curve, std::size_t m, const Limits& limits = {});

/// How often the seam must be a knot for this order of contact: n - k, and once where the order is infinite.
/// Errors: `not_continuous` for order -1, with the contact as its reason.
std::size_t seam_multiplicity(std::size_t degree, const Contact& contact, const Rational& seam);

}  // namespace blossom
