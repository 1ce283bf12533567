#pragma once

#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/core/nurbs/rational_curve.hpp>
#include <blossom/rational/limits.hpp>

namespace blossom {

// A rational B-spline (NURBS) is a B-spline of homogeneous points (w P, w). See rational_curve.hpp for the
// functions that apply to all curves.

/// The derivative of order k of the projected spline at t, on the segment that `de_boor` uses, by the
/// quotient rule.
///
/// `curve` has d + 1 coordinates, the result has d. Cost: k + 1 blossom values and k^2 / 2 products.
/// Errors: `outside_domain`; `zero_weight` if the weight vanishes at t; `limit_exceeded`.
Coordinates rational_derivative(const BSplineCurve& curve, std::size_t order, const Parameter& t,
                                const Limits& limits = {});

/// The derivative of order k of the projected spline as a rational B-spline of degree n (k + 1) with the
/// least knot multiplicities: `rational_derivative_map` of each segment, then `join`. Cost and errors: those
/// of these functions.
BSplineCurve rational_derivative_curve(const BSplineCurve& curve, std::size_t order,
                                       const Limits& limits = {});

/// The contact of the projected segments on the two sides of s.
/// Errors: `outside_domain` unless s is strictly inside the domain; those of `projected_contact` for maps.
ProjectedContact projected_contact(const BSplineCurve& curve, const Rational& s, const Limits& limits = {});

/// The contact of the projected curve at its seam, see `seam_contact`.
ProjectedContact projected_seam_contact(const BSplineCurve& curve, const Limits& limits = {});

/// How often the seam must be a knot for the homogeneous points of its sides to meet, once those on the right
/// are multiplied by a number; see `seam_multiplicity`. Errors: `not_continuous`.
std::size_t rational_seam_multiplicity(const BSplineCurve& curve, const Limits& limits = {});

}  // namespace blossom
