#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/worked/chapters.hpp>

#include "curve_pictures.hpp"
#include "symbols.hpp"

namespace blossom::worked {

namespace {

/// q(a^(m-i), b^i) = i/m p(a^(n-i+1), b^(i-1)) + (m-i)/m p(a^(n-i), b^i), with m = n + 1.
Formula raised_equation(const BezierCurve& before, const BezierCurve& after, std::size_t i,
                        const std::string& old_name, const std::string& new_name) {
    const std::size_t m = after.degree();
    const auto value = [&](std::size_t k) { return value_of_blossom(end_arguments(before, k), old_name); };
    std::vector<std::pair<Rational, Formula>> terms;
    if (i > 0) terms.emplace_back(Rational(i) / Rational(m), value(i - 1));
    if (i < m) terms.emplace_back(Rational(m - i) / Rational(m), value(i));
    return equation({value_of_blossom(end_arguments(after, i), new_name), combination(terms),
                     point_formula(after.control_points()[i])});
}

/// The names of the blossoms: p, q, then q2, q3, ....
std::string raised_name(std::size_t step) {
    if (step == 0) return "p";
    return step == 1 ? "q" : "q" + std::to_string(step);
}

/// The mean of the values of p that leave one argument out.
Formula mean_formula(std::size_t m, const std::string& old_name, const std::string& new_name) {
    const std::vector<Formula> all = numbered_symbols("u", m);
    std::vector<std::pair<Rational, Formula>> terms;
    for (std::size_t left_out = m; left_out-- > 0;) {
        std::vector<Formula> rest = all;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(left_out));
        terms.emplace_back(Rational(1) / Rational(m), blossom_of(old_name, std::move(rest)));
    }
    return equation({blossom_of(new_name, all), combination(terms)});
}

std::optional<Picture> raised_picture(const PolynomialMap& map, const BezierCurve& before,
                                      const BezierCurve& after, const std::string& name,
                                      const Limits& limits) {
    const auto plane = plane_map(before, limits);
    if (!plane || !plane_map(map, limits)) return std::nullopt;
    const BezierCurve old_points = bezier_form(plane->map, limits);
    const BezierCurve new_points = elevate(old_points, after.degree() - before.degree(), limits);
    Picture picture{"The old control polygon and the new one, nearer to the curve.",
                    "The new control points lie on the legs of the polygon before.",
                    {},
                    {},
                    {},
                    plane->graph};
    picture.curves = curves_over(plane->map, before.interval(), Role::control, limits);
    const bool named = after.degree() <= 6;
    add_polygon(picture, before, old_points.control_points(), Role::control, named_by("p"), named);
    add_polygon(picture, after, new_points.control_points(), Role::result, named_by(name), named);
    return picture;
}

}  // namespace

Document degree_raised(const GivenMap& given, std::size_t times, const Limits& limits) {
    require_within(degree_of(given.map) + times, page_degree, "page degree", "raised degree");
    Document document = begun(given, "Degree raising", "DeRose, section 4.4; Goldman, exercise 12");
    const BezierCurve first = bezier_form(given.map, limits);
    document.statement.say(
        {"Find the control points of the same map as one of degree ", number(first.degree() + times), "."});
    BezierCurve current = first;
    for (std::size_t step = 1; step <= times; ++step) {
        const BezierCurve next = elevate(current, 1, limits);
        const std::string before = raised_name(step - 1);
        const std::string after = raised_name(step);
        std::string map = after;
        map.front() = 'Q';
        document.maps.push_back({map, after, given.variable, PolynomialMap(next)});
        std::vector<Formula> equations;
        for (std::size_t i = 0; i <= next.degree(); ++i) {
            equations.push_back(raised_equation(current, next, i, before, after));
        }
        document
            .step("From degree " + std::to_string(current.degree()) + " to degree " +
                  std::to_string(next.degree()))
            .say(
                "The mean over the ways to leave out one argument is symmetric and "
                "affine in each, and on "
                "the diagonal it is the map: it is the blossom.")
            .show({mean_formula(next.degree(), before, after)})
            .say("At the ends of the interval many of the terms are equal:")
            .show(std::move(equations));
        current = next;
    }
    document.result.show(control_point_equations(current, named_by(raised_name(times))));
    document.result.add_if(raised_picture(given.map, first, current, raised_name(times), limits));
    const PolynomialCurve back = monomial_form(current, limits);
    document.check = {
        {Paragraph{
             "Turned into coefficients, the new control points give the map, with zeros above its degree:"},
         Display{{polynomial_equation(back, given.variable, limits)}}},
        back == elevate(monomial_form(given.map, limits), times, limits)};
    return document;
}

}  // namespace blossom::worked
