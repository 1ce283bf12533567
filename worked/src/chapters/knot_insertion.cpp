#include <blossom/core/spline/de_boor.hpp>
#include <blossom/core/spline/knot_insertion.hpp>
#include <blossom/rational/lists.hpp>
#include <blossom/worked/chapters.hpp>

#include <algorithm>
#include <array>

#include "splines.hpp"

namespace blossom::worked {

namespace {

/// The new control points whose window has the new knot, each as a combination of two old neighbours.
std::vector<Formula> new_points(const BSplineCurve& before, const Rational& knot, const Limits& limits) {
    const std::size_t span = before.knots().span_at(knot);
    const TrianglePyramid triangle =
        de_boor_triangle(before, span, with_copies({}, before.degree(), Parameter(knot)), "", limits);
    std::vector<Formula> equations;
    if (triangle.levels.size() < 2) return equations;
    for (std::size_t i = 0; i < triangle.levels[1].size(); ++i) {
        const PyramidNode& node = triangle.levels[1][i];
        equations.push_back(
            equation({node.label,
                      combination({{node.left_weight->value, triangle.levels[0][i].label},
                                   {node.right_weight->value, triangle.levels[0][i + 1].label}}),
                      node.value}));
    }
    return equations;
}

Picture insertion_picture(const PlaneSpline& before, const PlaneSpline& after, const Limits& limits) {
    Picture picture =
        spline_picture(before, "The old control polygon and the new one, nearer to the curve.", limits);
    PictureLine line{{}, Role::result};
    for (std::size_t j = 0; j < after.curve.control_points().size(); ++j) {
        const PlanePoint place = place_of(after.curve.control_points()[j]);
        line.places.push_back(place);
        const bool old = std::ranges::any_of(picture.points,
                                             [&](const PicturePoint& point) { return point.place == place; });
        if (!old) {
            const auto window = window_arguments(after.curve.knots(), j);
            picture.points.push_back({place, value_of_blossom(window, "g"), Role::result});
        }
    }
    picture.lines.push_back(std::move(line));
    return picture;
}

}  // namespace

Document knots_inserted(const BSplineCurve& curve, std::span<const Rational> knots, const Limits& limits) {
    Document document =
        begun(curve, "Knot insertion by Boehm's algorithm", "Hart, knot insertion; DeRose, section 4.7");
    std::vector<Formula> wanted = mapped(knots, number);
    document.statement.say(
        {"Find the control points of the same curve with the further knots ", tuple(std::move(wanted)), "."});
    BSplineCurve current = curve;
    for (const Rational& knot : knots) {
        const BSplineCurve next = insert_knots_boehm(current, std::array{knot}, limits);
        document.step("The knot " + to_string(knot))
            .say({"Every control point whose arguments the new knot ", number(knot),
                  " would interrupt is replaced. A new value differs from two old neighbours in one "
                  "argument, and combines them:"})
            .show(new_points(current, knot, limits));
        current = next;
    }
    document.maps.push_back({"G", "g", "t", current});
    std::vector<Formula> equations;
    for (std::size_t j = 0; j < current.control_points().size(); ++j) {
        Formula value = value_of_blossom(window_arguments(current.knots(), j), "g");
        equations.push_back(equation({std::move(value), point_formula(current.control_points()[j])}));
    }
    document.result.say({"The same curve over the new knots, its blossom called g there:"});
    document.result.show(std::move(equations));
    const auto plane = plane_spline(curve);
    const auto refined = plane_spline(current);
    if (plane && refined) document.result.add(insertion_picture(*plane, *refined, limits));
    const BSplineCurve oslo = insert_knots_oslo(curve, knots, limits);
    std::vector<Formula> values;
    const Interval domain = curve.knots().domain();
    for (std::size_t part = 1; part < 3; ++part) {
        const Rational t = domain.a() + Rational(part) / Rational(3) * (domain.b() - domain.a());
        values.push_back(equation(
            {call("F", {number(t)}), call("G", {number(t)}), point_formula(de_boor(current, t, limits))}));
    }
    document.check = {
        {Paragraph{"The Oslo algorithm, which evaluates every new control point by itself, gives the same "
                   "points, and both curves have the same values, for instance:"},
         Display{std::move(values)}},
        oslo == current};
    return document;
}

}  // namespace blossom::worked
