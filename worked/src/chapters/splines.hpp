#pragma once

#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/worked/chapters.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "curve_pictures.hpp"

namespace blossom::worked {

/// f(arguments) of the segment on a span; without a span at consecutive knots, where all segments agree.
Formula spline_value(std::span<const Argument> arguments, std::optional<std::size_t> span = {});

Naming named_on(std::size_t span);

/// The window of n knots of a control point.
std::vector<Argument> window_arguments(const KnotVector& knots, std::size_t point);

/// f(t_(j+1), ..., t_(j+n)) = P_j for all control points.
std::vector<Formula> spline_equations(const BSplineCurve& curve);

/// A document on a B-spline F with blossom f: its knots and its control points as values.
/// Errors: `limit_exceeded` for a degree above `page_degree` or more than `page_points` control points.
Document begun(const BSplineCurve& curve, std::string title, std::string source);
constexpr std::size_t page_points = 40;

/// A spline in the plane for pictures, as `plane_map`: the graph of a scalar one has the means of the windows
/// as abscissae.
struct PlaneSpline {
    BSplineCurve curve;
    bool graph = false;
};
std::optional<PlaneSpline> plane_spline(const BSplineCurve& curve);

/// The curve with its control polygon, each control point named by its blossom value.
Picture spline_picture(const PlaneSpline& plane, std::string caption, const Limits& limits);

/// De Boor's triangle of a segment, with one argument per level.
TrianglePyramid de_boor_triangle(const BSplineCurve& curve, std::size_t span,
                                 std::span<const Argument> arguments, std::string caption,
                                 const Limits& limits);

}  // namespace blossom::worked
