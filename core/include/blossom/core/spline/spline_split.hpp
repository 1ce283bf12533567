#pragma once

#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <utility>

namespace blossom {

/// The parts of the curve before and behind u. Insertion until u has multiplicity n gives the control point
/// f(u, ..., u), which ends the first part and begins the second. Where the curve jumps, at a knot of
/// multiplicity n + 1, the two points differ.
///
/// The convention is kept: u becomes an end knot of multiplicity n + 1 in the textbook convention, n in the
/// polar one. Cost for m points: O(m + n^2) points. Errors: `outside_domain` unless u is strictly inside the
/// domain; `limit_exceeded`. Source: Hart, "De Boor". Statement: hart-deboor-subdivide.
std::pair<BSplineCurve, BSplineCurve> split(const BSplineCurve& curve, const Rational& u,
                                            const Limits& limits = {});

/// The curve over [a, b] only, by two splits. An end that is also an end of the domain leaves the knots on
/// its side unchanged. Errors: `outside_domain` unless [a, b] lies in the domain and a < b; `limit_exceeded`.
/// Source: Hart, "De Boor". Statement: hart-deboor-subdivide.
BSplineCurve restricted(const BSplineCurve& curve, const Interval& interval, const Limits& limits = {});

/// The same curve with its ends as often as the convention has room for them, n + 1 or n times, and no knots
/// outside the domain: the first and the last control point are its ends. The new ones are the blossom values
/// at windows of the new knots. Cost for m points: O(m + n^2) points. Errors: `limit_exceeded`. Source:
/// DeRose, section 4.7. Statement: derose-boehm-new.
BSplineCurve clamped(const BSplineCurve& curve, const Limits& limits = {});

/// The curve over [a, b] alone, clamped. Errors: those of `restricted`.
BSplineCurve trimmed(const BSplineCurve& curve, const Interval& interval, const Limits& limits = {});

}  // namespace blossom
