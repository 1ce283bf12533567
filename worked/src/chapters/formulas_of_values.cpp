#include "formulas_of_values.hpp"

#include <blossom/core/blossom/conversion.hpp>
#include <blossom/rational/lists.hpp>

namespace blossom::worked {

Formula point_formula(const Coordinates& point) {
    if (point.size() == 1) return number(point.front());
    return tuple(mapped(point, number));
}

Formula argument_formula(const Argument& argument) {
    if (argument.mass == Rational(1)) return number(argument.u);
    if (!argument.mass.is_zero()) return tuple({number(argument.u), number(argument.mass)});
    if (argument.u == Rational(1)) return symbol("delta");
    return product({number(argument.u), symbol("delta")});
}

std::vector<Formula> argument_formulas(std::span<const Argument> arguments) {
    return mapped(arguments, argument_formula);
}

Formula value_of_blossom(std::span<const Argument> arguments, const std::string& name) {
    return blossom_of(name, argument_formulas(arguments));
}

Naming named_by(std::string blossom) {
    return [blossom = std::move(blossom)](std::span<const Argument> arguments) {
        return value_of_blossom(arguments, blossom);
    };
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

BezierCurve bezier_form(const PolynomialMap& map, const Limits& limits) {
    if (const auto* bezier = std::get_if<BezierCurve>(&map)) return *bezier;
    return control_points(std::get<PolynomialCurve>(map), Interval(), limits);
}

std::vector<Argument> end_arguments(const Interval& interval, std::size_t n, std::size_t k) {
    return with_copies(with_copies({}, n - k, Parameter(interval.a())), k, Parameter(interval.b()));
}

std::vector<Argument> end_arguments(const BezierCurve& curve, std::size_t k) {
    return end_arguments(curve.interval(), curve.degree(), k);
}

std::vector<Formula> control_point_equations(const BezierCurve& curve, const Naming& name) {
    std::vector<Formula> equations;
    for (std::size_t k = 0; k <= curve.degree(); ++k) {
        equations.push_back(
            equation({name(end_arguments(curve, k)), point_formula(curve.control_points()[k])}));
    }
    return equations;
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
    return {control_point_equations(std::get<BezierCurve>(given.map))};
}

Formula polynomial_equation(const PolynomialMap& map, const std::string& variable, const Limits& limits) {
    return definition_of({monomial_form(map, limits), variable}).formulas.front();
}

Formula division(const Coordinates& homogeneous) {
    const Coordinates others(homogeneous.begin(), homogeneous.end() - 1);
    return product({number(Rational(1) / homogeneous.back()), point_formula(others)});
}

Document begun(const GivenMap& given, std::string title, std::string source) {
    const std::size_t n = degree_of(given.map);
    require_within(n, page_degree, "page degree", "formal degree");
    Document document;
    document.title = std::move(title);
    document.source = std::move(source);
    document.maps.push_back({"P", "p", given.variable, given.map});
    const bool polynomial = std::holds_alternative<PolynomialCurve>(given.map);
    document.statement.say(
        polynomial ? Text{"Given the polynomial map of formal degree ", number(n), ":"}
                   : Text{"Given the Bézier curve of degree ", number(n),
                          " by its control points, the values of its blossom at the ends of its interval:"});
    document.statement.add(definition_of(given));
    return document;
}

}  // namespace blossom::worked
