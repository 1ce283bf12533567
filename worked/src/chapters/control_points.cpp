#include <blossom/core/blossom/conversion.hpp>
#include <blossom/worked/chapters.hpp>

#include <algorithm>

#include "curve_pictures.hpp"
#include "symbols.hpp"

namespace blossom::worked {

namespace {

/// The values by elementary symmetric functions, all in one table: e_k at (a^(n-i), b^i).
Table symmetric_table(const PolynomialCurve& curve, const BezierCurve& polygon) {
    const std::size_t n = curve.degree();
    Table table{
        "The elementary symmetric functions of the arguments of each control point.", {"arguments"}, {}};
    for (std::size_t k = 0; k <= n; ++k) table.header.emplace_back(index(symbol("e"), number(k)));
    table.header.emplace_back("value");
    for (std::size_t i = 0; i <= n; ++i) {
        const auto arguments = end_arguments(polygon, i);
        std::vector<Cell> row{tuple(argument_formulas(arguments))};
        const std::vector<Rational> values = elementary_values(arguments);
        for (std::size_t k = 0; k <= n; ++k) {
            row.emplace_back(number(values[k]), elementary(k, argument_formulas(arguments)));
        }
        row.emplace_back(point_formula(polygon.control_points()[i]), value_of_blossom(arguments));
        table.rows.push_back(std::move(row));
    }
    return table;
}

bool is_one(const Coordinates& point) { return point.size() == 1 && point.front() == Rational(1); }

/// p(u_1, ..., u_n) = sum of coefficients e_k / C(n, k).
Formula symmetric_formula(const PolynomialCurve& curve) {
    const std::size_t n = curve.degree();
    const std::vector<Formula> variables = numbered_symbols("u", n);
    std::vector<Formula> terms;
    for (std::size_t k = 0; k <= n; ++k) {
        const Coordinates c = curve.coefficients()[k];
        if (std::ranges::all_of(c, [](const Rational& one) { return one.is_zero(); })) continue;
        const Formula e = elementary(k, variables);
        const Formula weight = k == 0 || k == n ? e : fraction(e, binomial_of(number(n), number(k)));
        terms.push_back(is_one(c) ? weight : product({point_formula(c), weight}));
    }
    return equation({blossom_of("p", variables), sum(std::move(terms))});
}

Picture polygon_picture(const PlaneMap& plane, const BezierCurve& polygon, const Limits& limits) {
    const Interval& interval = polygon.interval();
    const BezierCurve points =
        std::visit([&](const auto& curve) { return control_points(curve, interval, limits); }, plane.map);
    Picture picture;
    picture.caption = "The control polygon and the curve over the interval.";
    picture.description = "Each control point is named by its blossom value.";
    picture.graph = plane.graph;
    add_polygon(picture, polygon, points.control_points(), Role::control, named_by("p"));
    picture.curves = curves_over(plane.map, interval, Role::control, limits);
    return picture;
}

/// From one polygon to another: a pyramid for each inner point would repeat itself; both edges of the one at
/// b, and then those at a, have all of them.
void append_subdivisions(Blocks& step, const BezierCurve& given, const Interval& interval,
                         const Limits& limits) {
    step.say({"Each value is the apex of a pyramid over ",
              interval_of(number(given.interval().a()), number(given.interval().b())),
              ". This is the one of the last but one control point:"});
    const std::size_t n = given.degree();
    const auto arguments = end_arguments(interval, n, n > 0 ? n - 1 : 0);
    step.add(casteljau_triangle(given, arguments, "One value as the apex of a pyramid.", limits));
}

}  // namespace

Document control_points_over(const GivenMap& given, const Interval& interval, const Limits& limits) {
    Document document =
        begun(given, "Control points over an interval", "Goldman, theorem 4: the dual functional property");
    document.statement.say({"Find the Bézier control points over ",
                            interval_of(number(interval.a()), number(interval.b())), "."});
    const BezierCurve polygon =
        std::visit([&](const auto& curve) { return control_points(curve, interval, limits); }, given.map);
    document.step("Which values they are")
        .say({"Control point ", symbol("k"), " is the value of the blossom at ",
              sum({number(polygon.degree()), product({number(-1), symbol("k")})}), " copies of ",
              number(interval.a()), " and ", symbol("k"), " copies of ", number(interval.b()), "."});
    if (const auto* bezier = std::get_if<BezierCurve>(&given.map)) {
        append_subdivisions(document.step("From the given polygon"), *bezier, interval, limits);
    } else {
        const auto& curve = std::get<PolynomialCurve>(given.map);
        document.step("Their values")
            .say("By elementary symmetric functions the blossom is")
            .show({symmetric_formula(curve)})
            .say("and at the arguments of the control points")
            .add(symmetric_table(curve, polygon));
    }
    document.result.show(control_point_equations(polygon));
    if (const auto plane = plane_map(given.map, limits)) {
        document.result.add(polygon_picture(*plane, polygon, limits));
    }
    const PolynomialCurve back = monomial_form(polygon, limits);
    document.check = {{Paragraph{"Turned back into coefficients, the control points give the map again:"},
                       Display{{polynomial_equation(back, given.variable, limits)}}},
                      back == monomial_form(given.map, limits)};
    return document;
}

}  // namespace blossom::worked
