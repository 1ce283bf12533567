#include "splines.hpp"

#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/de_boor.hpp>
#include <blossom/rational/lists.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace blossom::worked {

namespace {

std::vector<Argument> points_of(std::span<const Rational> parameters) {
    return mapped(parameters, [&](const Rational& parameter) { return Argument(Parameter(parameter)); });
}

Rational mean(std::span<const Rational> numbers) {
    Rational total;
    for (const Rational& value : numbers) total += value;
    return total / Rational(numbers.size());
}

}  // namespace

Formula spline_value(std::span<const Argument> arguments, std::optional<std::size_t> span) {
    Formula formula = value_of_blossom(arguments, "f");
    if (span) formula.value = Rational(*span + 1);
    return formula;
}

Naming named_on(std::size_t span) {
    return [span](std::span<const Argument> arguments) { return spline_value(arguments, span); };
}

std::vector<Argument> window_arguments(const KnotVector& knots, std::size_t point) {
    return points_of(knots.window(point));
}

std::vector<Formula> spline_equations(const BSplineCurve& curve) {
    std::vector<Formula> equations;
    equations.reserve(curve.control_points().size());
    for (std::size_t j = 0; j < curve.control_points().size(); ++j) {
        equations.push_back(equation(
            {spline_value(window_arguments(curve.knots(), j)), point_formula(curve.control_points()[j])}));
    }
    return equations;
}

Document begun(const BSplineCurve& curve, std::string title, std::string source) {
    require_within(curve.degree(), page_degree, "page degree", "degree");
    require_within(curve.control_points().size(), page_points, "page control points",
                   "number of control points");
    Document document;
    document.title = std::move(title);
    document.source = std::move(source);
    document.maps.push_back({"F", "f", "t", curve});
    std::vector<Formula> knots = mapped(curve.knots().knots(), number);
    document.statement.say({"Given the B-spline curve of degree ", number(curve.degree()), " over the knots ",
                            tuple(std::move(knots)),
                            ". Its control points are values of the blossoms of its segments at ",
                            number(curve.degree()), " consecutive knots:"});
    document.statement.show(spline_equations(curve));
    return document;
}

std::optional<PlaneSpline> plane_spline(const BSplineCurve& curve) {
    if (curve.degree() == 0 || curve.dimension() > 2) return std::nullopt;
    if (curve.dimension() == 2) return PlaneSpline{curve, false};
    std::vector<Coordinates> points;
    points.reserve(curve.control_points().size());
    for (std::size_t j = 0; j < curve.control_points().size(); ++j) {
        points.push_back({mean(curve.knots().window(j)), curve.control_points()[j][0]});
    }
    return PlaneSpline{BSplineCurve(curve.knots(), std::move(points)), true};
}

Picture spline_picture(const PlaneSpline& plane, std::string caption, const Limits& limits) {
    Picture picture;
    picture.caption = std::move(caption);
    picture.description = "The control polygon, its points named by their blossom values, and the curve.";
    picture.graph = plane.graph;
    PictureLine polygon{{}, Role::control};
    for (std::size_t j = 0; j < plane.curve.control_points().size(); ++j) {
        const PlanePoint place = place_of(plane.curve.control_points()[j]);
        polygon.places.push_back(place);
        picture.points.push_back(
            {place, spline_value(window_arguments(plane.curve.knots(), j)), Role::control});
    }
    picture.lines.push_back(std::move(polygon));
    for (const BezierCurve& segment : bezier_segments(plane.curve, limits)) {
        std::ranges::move(curves_over(segment, segment.interval(), Role::control, limits),
                          std::back_inserter(picture.curves));
    }
    return picture;
}

TrianglePyramid de_boor_triangle(const BSplineCurve& curve, std::size_t span,
                                 std::span<const Argument> arguments, std::string caption,
                                 const Limits& limits) {
    const std::size_t n = curve.degree();
    const std::vector<Argument> around = points_of(curve.knots().around(span));
    const auto label = [&](std::size_t r, std::size_t i) {
        std::vector<Argument> all(arguments.begin(), arguments.begin() + static_cast<std::ptrdiff_t>(r));
        for (std::size_t j = r + i; j < n + i; ++j) all.push_back(around[j]);
        return ordered(std::move(all));
    };
    const auto weights = [&](std::size_t r, std::size_t i) {
        const Rational& begin = around[r - 1 + i].u;
        const Rational& end = around[n + i].u;
        const Argument& u = arguments[r - 1];
        return std::pair((end * u.mass - u.u) / (end - begin), (u.u - begin * u.mass) / (end - begin));
    };
    const auto value = [&](std::span<const Argument> at) { return segment_blossom(curve, span, at, limits); };
    return triangle_by({n, label, weights, value, named_on(span)}, std::move(caption));
}

}  // namespace blossom::worked
