#pragma once

#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/rational/limits.hpp>
#include <blossom/worked/document.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

/// The chapters: each takes any input and works it out, step by step, on the numbers of the engine.

namespace blossom::worked {

/// The greatest formal degree for which pages are made; larger ones would be unreadable. Errors of all
/// chapters: `limit_exceeded`, and those of the computation that is shown.
constexpr std::size_t page_degree = 12;

/// A polynomial map and the name of its parameter.
struct GivenMap {
    PolynomialMap map;
    std::string variable = "t";
};

/// The blossom value at given arguments three ways: elementary symmetric functions written out, the table of
/// the polarization formula, de Casteljau's pyramid.
/// Source: Goldman, proposition 1 and figure 3; Fernandez-Jambrina, corollary 1.
Document three_ways(const GivenMap& given, std::span<const Argument> arguments, const Limits& limits = {});

/// The square of Goldman, figures 4 and 5: blossom then homogenise, homogenise then blossom, computed by
/// different roads and compared as polynomials in all arguments; the monomials up to the degree in a table.
Document homogenisation(const GivenMap& given, const Limits& limits = {});

/// P(t) by de Casteljau's algorithm, checked by Horner's rule. Source: Goldman, figures 1 and 2.
Document evaluation_at(const GivenMap& given, const Parameter& t, const Limits& limits = {});

/// P^(k)(t) = n!/(n-k)! p(t^(n-k), delta^k), as the triangles of Goldman, figures 9 and 10.
Document derivative_by_delta(const GivenMap& given, std::size_t order, const Parameter& t,
                             const Limits& limits = {});

/// The control points over an interval as blossom values at its ends. Source: Goldman, theorem 4.
Document control_points_over(const GivenMap& given, const Interval& interval, const Limits& limits = {});

/// Both control polygons on the lateral edges of the pyramid at t. Source: Goldman, section 3.
Document subdivision_at(const GivenMap& given, const Parameter& t, const Limits& limits = {});

/// The degree raised by one, `times` times, by averaging blossoms. Source: DeRose, section 4.4.
Document degree_raised(const GivenMap& given, std::size_t times, const Limits& limits = {});

/// Between coefficients and control points over [0, 1] by the triangles of Goldman, figure 11.
Document coefficients_to_control_points(const GivenMap& given, const Limits& limits = {});
Document control_points_to_coefficients(const GivenMap& given, const Limits& limits = {});

/// F(t) by de Boor's triangle, checked by the Bezier curve of the segment. Source: DeRose, figure 10.
Document de_boor_at(const BSplineCurve& curve, const Parameter& t, const Limits& limits = {});

/// The Bezier control points of every segment. Source: DeRose, figure 9; Hart, "B-spline to Bezier".
Document spline_to_bezier(const BSplineCurve& curve, const Limits& limits = {});

/// Boehm's algorithm, knot by knot, checked by the Oslo algorithm. Source: DeRose, section 4.7.
Document knots_inserted(const BSplineCurve& curve, std::span<const Rational> knots,
                        const Limits& limits = {});

/// The order of contact of the segments at a parameter, from their blossoms. Source: DeRose,
/// theorem 2.
Document continuity_at(const BSplineCurve& curve, const Rational& knot, const Limits& limits = {});

/// A point of a rational curve, whose last coordinate is the weight. Errors: `zero_weight`.
Document rational_arc(const GivenMap& given, const Parameter& t, const Limits& limits = {});

}  // namespace blossom::worked
