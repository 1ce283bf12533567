#include <blossom/core/blossom/conversion.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/worked/chapters.hpp>

#include "curve_pictures.hpp"

namespace blossom::worked {

namespace {

/// (1^r, 0^(n-r-i), delta^i), the label of figure 11(b).
std::vector<Argument> adding_label(std::size_t n, std::size_t r, std::size_t i) {
    std::vector<Argument> points =
        ordered(with_copies(with_copies({}, r, Parameter(1)), n - r - i, Parameter(0)));
    return with_copies(std::move(points), i, delta);
}

/// p(0^(n-k), delta^k) and the coefficient that belongs to it.
Formula normalised_equation(const PolynomialCurve& curve, std::size_t k) {
    const std::size_t n = curve.degree();
    const Coordinates coefficient = curve.coefficients()[k];
    Coordinates value = coefficient;
    for (Rational& coordinate : value) coordinate /= Rational(binomial(n, k));
    return equation(
        {value_of_blossom(with_copies(with_copies({}, n - k, Parameter(0)), k, delta)),
         product({fraction(number(1), binomial_of(number(n), number(k))), point_formula(coefficient)}),
         point_formula(value)});
}

std::vector<Formula> normalised_equations(const PolynomialCurve& curve) {
    std::vector<Formula> equations;
    for (std::size_t k = 0; k <= curve.degree(); ++k) equations.push_back(normalised_equation(curve, k));
    return equations;
}

void mark_upper_edge(TrianglePyramid& triangle) {
    for (auto& level : triangle.levels) level.front().on_left_edge = true;
}

}  // namespace

Document coefficients_to_control_points(const GivenMap& given, const Limits& limits) {
    const PolynomialCurve curve = monomial_form(given.map, limits);
    const std::size_t n = curve.degree();
    Document document = begun({curve, given.variable}, "From coefficients to control points",
                              "Goldman, section 5 and figure 11(b)");
    document.statement.say("Find its control points over [0, 1].");
    const Blossom p(curve, limits);
    TrianglePyramid triangle =
        triangle_by({n, [n](std::size_t r, std::size_t i) { return adding_label(n, r, i); },
                     [](std::size_t, std::size_t) { return std::pair<Rational, Rational>(1, 1); },
                     std::cref(p), named_by("p")},
                    "Every node is the sum of its two neighbours; the upper edge has the control points.");
    mark_upper_edge(triangle);
    document.step("Coefficients are blossom values")
        .say({"The coefficient of ", power(symbol(given.variable), symbol("k")),
              ", divided by a binomial coefficient, is the value with ", symbol("k"), " copies of ",
              symbol("delta"), ":"})
        .show(normalised_equations(curve));
    document.step("Adding instead of subtracting")
        .say({"As pairs, ", equation({number(1), sum({number(0), symbol("delta")})}),
              ": replacing a vector by the point 1 adds two values."})
        .add(std::move(triangle));
    const BezierCurve polygon = control_points(curve, Interval(), limits);
    document.result.show(control_point_equations(polygon));
    document.check = {{Paragraph{"Back from the control points to coefficients:"},
                       Display{{polynomial_equation(polygon, given.variable, limits)}}},
                      monomial_form(polygon, limits) == curve};
    return document;
}

Document control_points_to_coefficients(const GivenMap& given, const Limits& limits) {
    Document document =
        begun(given, "From control points to coefficients", "Goldman, section 5 and figure 11(a)");
    document.statement.say("Find its coefficients.");
    const BezierCurve bezier = bezier_form(given.map, limits);
    const BezierCurve unit = control_points(bezier, Interval(), limits);
    const std::size_t n = unit.degree();
    if (!(bezier.interval() == Interval())) {
        document.step("The control points over [0, 1]")
            .say(
                "The triangle wants control points over [0, 1]. They are blossom values "
                "like those over any interval:")
            .show(control_point_equations(unit));
    }
    TrianglePyramid triangle = casteljau_triangle(
        unit, with_copies({}, n, delta),
        "Every node is a difference; the upper edge has the normalised coefficients.", limits);
    mark_upper_edge(triangle);
    document.step("Differences")
        .say({"As pairs, ", equation({symbol("delta"), sum({number(1), product({number(-1), number(0)})})}),
              ": replacing a point by the vector subtracts two values. On every level the argument is ",
              symbol("delta"), "."})
        .add(std::move(triangle));
    const PolynomialCurve curve = monomial_form(bezier, limits);
    document.step("From values to coefficients")
        .say("Each value on the upper edge is a coefficient divided by a binomial coefficient:")
        .show(normalised_equations(curve));
    document.result.show({polynomial_equation(curve, given.variable, limits)});
    const BezierCurve back = control_points(curve, bezier.interval(), limits);
    document.check = {
        {Paragraph{"The polynomial has the given control points:"}, Display{control_point_equations(back)}},
        back.control_points() == bezier.control_points()};
    return document;
}

}  // namespace blossom::worked
