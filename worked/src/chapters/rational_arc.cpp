#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/blossom/evaluation.hpp>
#include <blossom/core/nurbs/rational_curve.hpp>
#include <blossom/rational/lists.hpp>
#include <blossom/worked/chapters.hpp>

#include "curve_pictures.hpp"

namespace blossom::worked {

namespace {

PlanePoint projected_place(const Coordinates& homogeneous) { return place_of(projected(homogeneous)); }

/// The coordinates one by one, as scalar maps that only meanings name: x1, x2, ... and the weight w.
std::string coordinate_name(std::size_t j, std::size_t dimension) {
    return j + 1 == dimension ? "w" : "x" + std::to_string(j + 1);
}

void name_coordinates(Document& document, const BezierCurve& curve) {
    for (std::size_t j = 0; j < curve.dimension(); ++j) {
        std::vector<Coordinates> points =
            mapped(curve.control_points().to_points(),
                   [&](const Coordinates& point) { return Coordinates{point[j]}; });
        const std::string name = coordinate_name(j, curve.dimension());
        std::string map = name;
        map.front() = j + 1 == curve.dimension() ? 'W' : 'X';
        document.maps.push_back({map, name, "t", PolynomialMap(BezierCurve(points, curve.interval()))});
    }
}

/// The value at the arguments divided by its weight, as formulas in these names.
Formula divided(const BezierCurve& curve, std::span<const Argument> arguments) {
    std::vector<Formula> coordinates;
    const Formula weight = value_of_blossom(arguments, "w");
    for (std::size_t j = 0; j + 1 < curve.dimension(); ++j) {
        coordinates.push_back(
            fraction(value_of_blossom(arguments, coordinate_name(j, curve.dimension())), weight));
    }
    return coordinates.size() == 1 ? coordinates.front() : tuple(std::move(coordinates));
}

/// The points P_k = (w P, w), projected to the plane, with their weights.
Table weight_table(const BezierCurve& curve) {
    Table table{
        "The control points, divided by their weights.", {"value", "homogeneous", "weight", "point"}, {}};
    const std::size_t n = curve.degree();
    for (std::size_t k = 0; k <= n; ++k) {
        const auto arguments = end_arguments(curve, k);
        const Coordinates point = curve.control_points()[k];
        const Rational& weight = point.back();
        const Formula name = value_of_blossom(arguments);
        std::vector<Cell> row{name, Cell(point_formula(point), name),
                              Cell(number(weight), value_of_blossom(arguments, "w"))};
        row.emplace_back(weight.is_zero() ? Cell("at infinity")
                                          : Cell(point_formula(projected(point)), divided(curve, arguments)));
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::optional<Picture> arc_picture(const BezierCurve& curve, const Parameter& t, const Limits& limits) {
    if (curve.dimension() != 3) return std::nullopt;
    Picture picture;
    picture.caption = "The arc with its control polygon.";
    picture.description = "The control points divided by their weights, and the point of the parameter.";
    PictureLine polygon{{}, Role::control};
    for (std::size_t k = 0; k <= curve.degree(); ++k) {
        const Coordinates point = curve.control_points()[k];
        if (point.back().is_zero()) return std::nullopt;
        const PlanePoint place = projected_place(point);
        polygon.places.push_back(place);
        const auto arguments = end_arguments(curve, k);
        picture.points.push_back(
            {place, index(symbol("P"), number(k)), Role::control, divided(curve, arguments)});
    }
    picture.lines.push_back(std::move(polygon));
    picture.curves = curves_over(curve, curve.interval(), Role::control, limits, true);
    picture.points.push_back({projected_place(evaluate(curve, t, limits)), symbol("C"), Role::result,
                              divided(curve, with_copies({}, curve.degree(), t))});
    return picture;
}

}  // namespace

Document rational_arc(const GivenMap& given, const Parameter& t, const Limits& limits) {
    Document document = begun(given, "A rational arc", "Fernández-Jambrina, section 5; Goldman, section 4");
    const BezierCurve bezier = bezier_form(given.map, limits);
    document.symbols = {"C"};
    name_coordinates(document, bezier);
    const Coordinates homogeneous = evaluate(bezier, t, limits);
    const Coordinates point = projected(homogeneous);
    const Formula at = call("P", {number(t.value)});
    document.statement.say(
        "The last coordinate is a weight: a point of the rational curve has the others divided by "
        "it.");
    document.statement.say(
        {"Find the point ", symbol("C"), " of the rational curve at ", number(t.value), "."});
    document.step("Control points with weights")
        .say("The blossom works on all coordinates alike.")
        .add(weight_table(bezier));
    document.step("De Casteljau's algorithm, weights included")
        .add(casteljau_triangle(bezier, with_copies({}, bezier.degree(), t),
                                "The pyramid in homogeneous coordinates.", limits));
    document.step("Divide by the weight")
        .show({equation({at, point_formula(homogeneous)}),
               equation({symbol("C"), division(homogeneous), point_formula(point)})});
    document.result.show({equation({symbol("C"), division(homogeneous), point_formula(point)})});
    document.result.add_if(arc_picture(bezier, t, limits));
    const Coordinates direct = evaluate(monomial_form(given.map, limits), t, limits);
    document.check = {
        {Paragraph{"The coefficients, evaluated directly, give the same point with its weight:"},
         Display{{polynomial_equation(given.map, given.variable, limits),
                  equation({at, point_formula(direct)})}}},
        direct == homogeneous};
    return document;
}

}  // namespace blossom::worked
