#include "formulas_of_values.hpp"

#include <blossom/core/blossom/conversion.hpp>

namespace blossom::worked {

Formula point_formula(const Coordinates& point) {
    if (point.size() == 1) return number(point.front());
    std::vector<Formula> coordinates;
    for (const Rational& coordinate : point) coordinates.push_back(number(coordinate));
    return tuple(std::move(coordinates));
}

Formula argument_formula(const Argument& argument) {
    if (argument.mass == Rational(1)) return number(argument.u);
    if (!argument.mass.is_zero()) return tuple({number(argument.u), number(argument.mass)});
    if (argument.u == Rational(1)) return symbol("delta");
    return product({number(argument.u), symbol("delta")});
}

std::vector<Formula> argument_formulas(std::span<const Argument> arguments) {
    std::vector<Formula> formulas;
    for (const Argument& argument : arguments) formulas.push_back(argument_formula(argument));
    return formulas;
}

Formula value_of_blossom(std::span<const Argument> arguments, const std::string& name) {
    return blossom_of(name, argument_formulas(arguments));
}

Formula polynomial_formula(const Polynomial& polynomial, const std::string& variable) {
    std::vector<Formula> terms;
    for (std::size_t k = 0; k <= polynomial.degree(); ++k) {
        const Rational coefficient = polynomial[k];
        if (coefficient.is_zero()) continue;
        std::vector<Formula> factors;
        if (k == 0 || coefficient != Rational(1)) factors.push_back(number(coefficient));
        if (k > 0) factors.push_back(power(symbol(variable), number(k)));
        terms.push_back(product(std::move(factors)));
    }
    return sum(std::move(terms));
}

Formula map_at_variable(const GivenMap& given) { return call("P", {symbol(given.variable)}); }

Formula combination(const std::vector<std::pair<Rational, Formula>>& terms) {
    std::vector<Formula> parts;
    parts.reserve(terms.size());
    for (const auto& [weight, formula] : terms) {
        parts.push_back(weight == Rational(1) ? formula : product({number(weight), formula}));
    }
    return sum(std::move(parts));
}

std::size_t degree_of(const PolynomialMap& map) {
    return std::visit([](const auto& curve) { return curve.degree(); }, map);
}

std::size_t dimension_of(const PolynomialMap& map) {
    return std::visit([](const auto& curve) { return curve.dimension(); }, map);
}

BezierCurve bezier_form(const PolynomialMap& map, const Limits& limits) {
    if (const auto* bezier = std::get_if<BezierCurve>(&map)) return *bezier;
    return control_points(std::get<PolynomialCurve>(map), Interval(), limits);
}

PolynomialCurve coefficient_form(const PolynomialMap& map, const Limits& limits) {
    if (const auto* curve = std::get_if<PolynomialCurve>(&map)) return *curve;
    return monomial_form(std::get<BezierCurve>(map), limits);
}

std::vector<Argument> end_arguments(const Rational& a, const Rational& b, std::size_t n, std::size_t k) {
    return with_copies(with_copies({}, n - k, Parameter(a)), k, Parameter(b));
}

Display definition_of(const GivenMap& given) {
    if (const auto* curve = std::get_if<PolynomialCurve>(&given.map)) {
        std::vector<Formula> coordinates;
        coordinates.reserve(curve->dimension());
        for (std::size_t j = 0; j < curve->dimension(); ++j) {
            coordinates.push_back(polynomial_formula(curve->coordinate(j), given.variable));
        }
        Formula right = coordinates.size() == 1 ? coordinates.front() : tuple(std::move(coordinates));
        return {{equation({map_at_variable(given), std::move(right)})}};
    }
    const auto& bezier = std::get<BezierCurve>(given.map);
    const std::size_t n = bezier.degree();
    Display display;
    for (std::size_t k = 0; k <= n; ++k) {
        const auto arguments = end_arguments(bezier.interval().a(), bezier.interval().b(), n, k);
        display.formulas.push_back(
            equation({value_of_blossom(arguments), point_formula(bezier.control_points()[k])}));
    }
    return display;
}

Document begun(const GivenMap& given, std::string title, std::string source) {
    const std::size_t n = degree_of(given.map);
    require_within(n, page_degree, "page degree", "formal degree");
    Document document;
    document.title = std::move(title);
    document.source = std::move(source);
    document.maps.push_back({"P", "p", given.variable, given.map});
    const bool polynomial = std::holds_alternative<PolynomialCurve>(given.map);
    std::string words =
        polynomial ? "Given the polynomial map of formal degree " : "Given the Bézier curve of degree ";
    Text text{words, number(n),
              polynomial ? ":" : ", by its control points, which are values of its blossom "};
    if (!polynomial)
        text = {words, number(n),
                " by its control points, the values of its blossom at the ends of its interval:"};
    document.statement.emplace_back(Paragraph{std::move(text)});
    document.statement.emplace_back(definition_of(given));
    return document;
}

}  // namespace blossom::worked
