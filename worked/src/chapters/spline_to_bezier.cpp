#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/continuity.hpp>
#include <blossom/worked/chapters.hpp>

#include "splines.hpp"

namespace blossom::worked {

namespace {

std::string interval_text(const Interval& interval) {
    return "[" + to_string(interval.a()) + ", " + to_string(interval.b()) + "]";
}

void append_segment(Document& document, const BSplineCurve& curve, std::size_t span,
                    const BezierCurve& bezier, const Limits& limits) {
    const Interval& interval = bezier.interval();
    document.step("The segment on " + interval_text(interval))
        .say({"Its Bézier control points are the values of its blossom at ", number(interval.a()), " and ",
              number(interval.b()),
              std::string(
                  ". De Boor's triangle replaces the knots of the control points of the spline by these, "
                  "one per level. This is the triangle of one of them; its lower levels have others too:")})
        .add(de_boor_triangle(curve, span, end_arguments(bezier, bezier.degree() / 2), "De Boor's triangle.",
                              limits));
}

Picture bezier_picture(const PlaneSpline& plane, const Limits& limits) {
    Picture picture =
        spline_picture(plane, "The B-spline polygon and the Bézier polygons of its segments.", limits);
    std::size_t index = 0;
    for (const std::size_t span : plane.curve.knots().spans()) {
        const BezierCurve bezier = sablonniere(plane.curve, span, limits);
        const Role role = index++ % 2 == 0 ? Role::result : Role::second;
        add_polygon(picture, bezier, bezier.control_points(), role, named_on(span),
                    plane.curve.knots().spans().size() <= 3);
    }
    return picture;
}

}  // namespace

Document spline_to_bezier(const BSplineCurve& curve, const Limits& limits) {
    Document document = begun(curve, "From a B-spline to Bézier curves",
                              "Hart, Boehm blossoms; DeRose, section 4.6 and figure 9");
    document.statement.say("Find the Bézier control points of all its segments.");
    const std::vector<std::size_t> spans = curve.knots().spans();
    std::vector<BezierCurve> segments;
    for (const std::size_t span : spans) {
        segments.push_back(sablonniere(curve, span, limits));
        append_segment(document, curve, span, segments.back(), limits);
        document.result.say({"Over " + interval_text(segments.back().interval()) + ":"});
        document.result.show(control_point_equations(segments.back(), named_on(span)));
    }
    if (const auto plane = plane_spline(curve)) document.result.add(bezier_picture(*plane, limits));
    bool holds = true;
    for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
        const Rational& knot = segments[i].interval().b();
        const Contact joint = contact(segments[i], segments[i + 1], knot, limits);
        const auto promised = static_cast<std::ptrdiff_t>(curve.degree()) -
                              static_cast<std::ptrdiff_t>(curve.knots().multiplicity(knot));
        holds = holds && (joint.is_infinite() || *joint.order >= promised);
    }
    document.check = {
        {Paragraph{
            segments.size() == 1
                ? Text{"There is one segment, and the spline is this Bézier curve."}
                : Text{std::string("Neighbouring segments meet at each knot at least as smoothly as its "
                                   "multiplicity promises: with order "),
                       sum({symbol("n"), product({number(-1), symbol("m")})}), " at a knot of multiplicity ",
                       symbol("m"), " in a spline of degree ", symbol("n"), "."}}},
        holds};
    return document;
}

}  // namespace blossom::worked
