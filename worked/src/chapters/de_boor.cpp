#include <blossom/core/blossom/evaluation.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/de_boor.hpp>
#include <blossom/worked/chapters.hpp>

#include "splines.hpp"

namespace blossom::worked {

namespace {

/// The nodes of de Boor's triangle as points in the plane.
Picture construction(const PlaneSpline& plane, std::size_t span, std::span<const Argument> arguments,
                     const Limits& limits) {
    Picture picture = spline_picture(plane, "De Boor's construction in the plane.", limits);
    const TrianglePyramid triangle = de_boor_triangle(plane.curve, span, arguments, "", limits);
    const std::size_t n = plane.curve.degree();
    for (std::size_t r = 0; r < triangle.levels.size(); ++r) {
        const Role role = r == n ? Role::result : Role::construction;
        PictureLine line{{}, role};
        for (const PyramidNode& node : triangle.levels[r]) {
            const PlanePoint place{node.value.parts[0].value, node.value.parts[1].value};
            line.places.push_back(place);
            if (r > 0 && (n <= 3 || r == n)) picture.points.push_back({place, node.label, role});
        }
        if (r > 0 && r < n) picture.lines.push_back(std::move(line));
    }
    return picture;
}

/// The value by the Bezier curve of the segment, as a check.
Check de_boor_check(const BSplineCurve& curve, std::size_t span, const Parameter& t, const Coordinates& value,
                    const Limits& limits) {
    const BezierCurve bezier = sablonniere(curve, span, limits);
    const Coordinates direct = evaluate(bezier, t, limits);
    return {{Paragraph{"The segment as a Bézier curve has the control points"},
             Display{control_point_equations(bezier, named_on(span))},
             Paragraph{"and de Casteljau's algorithm gives the same value:"},
             Display{{equation({call("F", {number(t.value)}), point_formula(direct)})}}},
            direct == value};
}

}  // namespace

Document de_boor_at(const BSplineCurve& curve, const Parameter& t, const Limits& limits) {
    Document document =
        begun(curve, "De Boor's algorithm", "Hart, de Boor; DeRose, section 4.6 and figure 10");
    const std::size_t span = curve.knots().span_at(t.value);
    const std::vector<Argument> arguments = with_copies({}, curve.degree(), t);
    const Formula wanted = call("F", {number(t.value)});
    document.statement.say({"Find ", wanted, "."});
    Text used{"The parameter lies between the knots ", number(curve.knots()[span]), " and ",
              number(curve.knots()[span + 1]),
              ". Only those control points count whose knots reach this span: "};
    for (std::size_t i = 0; i <= curve.degree(); ++i) {
        if (i > 0) used.append(std::string(i == curve.degree() ? " and " : ", "));
        used.append(spline_value(window_arguments(curve.knots(), curve.knots().first_point(span) + i)));
    }
    used.append(".");
    document.step("The segment").say(std::move(used));
    Blocks& triangle = document.step("Knots are replaced by the parameter, one per level");
    triangle
        .say(
            "Each node combines two neighbours whose arguments differ in one knot; the weights are the "
            "coordinates of the parameter between these two knots.")
        .add(de_boor_triangle(curve, span, arguments, "De Boor's triangle.", limits));
    if (const auto plane = plane_spline(curve)) triangle.add(construction(*plane, span, arguments, limits));
    const Coordinates value = de_boor(curve, t, limits);
    document.result.show({equation({wanted, spline_value(arguments, span), point_formula(value)})});
    document.check = de_boor_check(curve, span, t, value, limits);
    return document;
}

}  // namespace blossom::worked
