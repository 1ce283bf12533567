#include <blossom/core/blossom/conversion.hpp>
#include <blossom/worked/chapters.hpp>

#include "curve_pictures.hpp"

namespace blossom::worked {

namespace {

void mark_edges(TrianglePyramid& pyramid) {
    for (auto& level : pyramid.levels) {
        level.front().on_left_edge = true;
        level.back().on_right_edge = true;
    }
}

std::optional<Picture> both_polygons(const PolynomialMap& map, const BezierCurve& bezier, const Parameter& t,
                                     const Limits& limits) {
    const auto arguments = with_copies({}, bezier.degree(), t);
    auto picture = construction_picture(map, arguments, "Both control polygons beside the curve.", limits);
    if (!picture) return picture;
    picture->description +=
        " The left polygon and the right one are drawn in their own colours and line styles.";
    const BezierCurve plane = bezier_form(plane_map(map, limits)->map, limits);
    const auto [left, right] = subdivide(plane, t, limits);
    picture->lines.push_back({places_of(left.control_points()), Role::result});
    picture->lines.push_back({places_of(right.control_points()), Role::second});
    return picture;
}

}  // namespace

Document subdivision_at(const GivenMap& given, const Parameter& t, const Limits& limits) {
    Document document = begun(given, "Subdivision", "Goldman, section 3; DeRose, section 4.3");
    const BezierCurve bezier = bezier_form(given.map, limits);
    const Rational& a = bezier.interval().a();
    const Rational& b = bezier.interval().b();
    const auto [left, right] = subdivide(bezier, t, limits);
    document.statement.say({"Find its control points over ", interval_of(number(a), number(t.value)),
                            " and over ", interval_of(number(t.value), number(b)), "."});
    TrianglePyramid pyramid = casteljau_triangle(
        bezier, with_copies({}, bezier.degree(), t),
        "The pyramid: the upper edge has the left polygon, the lower edge the right one.", limits);
    mark_edges(pyramid);
    document.step("One pyramid has both")
        .say(
            "De Casteljau's pyramid has, along one lateral edge, the values with ever more copies of the "
            "parameter and ever fewer of the right end, and along the other the same for the left end. "
            "These are the required control points.")
        .add(std::move(pyramid))
        .add_if(both_polygons(given.map, bezier, t, limits));
    document.result.say("The left polygon:");
    document.result.show(control_point_equations(left));
    document.result.say("The right polygon:");
    document.result.show(control_point_equations(right));
    const PolynomialCurve whole = monomial_form(given.map, limits);
    document.check = {{Paragraph{"Both polygons, turned into coefficients, give the same map:"},
                       Display{{polynomial_equation(left, given.variable, limits)}}},
                      monomial_form(left, limits) == whole && monomial_form(right, limits) == whole};
    return document;
}

}  // namespace blossom::worked
