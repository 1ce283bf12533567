#pragma once

#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/core/nurbs/rational_curve.hpp>
#include <blossom/rational/limits.hpp>

namespace blossom {

// A rational B-spline (NURBS) is a B-spline of homogeneous points (w P, w). What is not particular to a
// spline stands in rational_curve.hpp.

/// The derivative of order k of the projected spline at t, on the segment of `de_boor`, by the quotient rule.
///
/// `curve` has d + 1 coordinates, the result d. Cost: k + 1 blossom values and k^2 / 2 products.
/// Errors: `outside_domain`; `zero_weight` where the weight vanishes; `limit_exceeded`.
Coordinates rational_derivative(const BSplineCurve& curve, std::size_t order, const Parameter& t,
                                const Limits& limits = {});

/// The derivative of order k of the projected spline as a rational B-spline of degree n (k + 1), with the
/// least knot multiplicities: `rational_derivative_map` of each segment, joined. Cost: that of its parts a
/// segment. Errors: those of its parts.
BSplineCurve rational_derivative_curve(const BSplineCurve& curve, std::size_t order,
                                       const Limits& limits = {});

/// The contact of the projected segments on the two sides of s.
/// Errors: `outside_domain` unless s lies strictly inside the domain; those of the other `projected_contact`.
ProjectedContact projected_contact(const BSplineCurve& curve, const Rational& s, const Limits& limits = {});

/// The contact of the projected curve at its seam, see `seam_contact`.
ProjectedContact projected_seam_contact(const BSplineCurve& curve, const Limits& limits = {});

/// How often the seam must be a knot for the homogeneous points of its sides to meet, once those on the right
/// are multiplied by a number; see `seam_multiplicity`. Errors: `not_continuous`.
std::size_t rational_seam_multiplicity(const BSplineCurve& curve, const Limits& limits = {});

}  // namespace blossom
