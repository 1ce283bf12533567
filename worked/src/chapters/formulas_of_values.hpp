#pragma once

#include <blossom/core/algebra/polynomial.hpp>
#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/worked/chapters.hpp>

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace blossom::worked {

/// A number, or the tuple of several.
Formula point_formula(const Coordinates& point);

/// 2, delta, 3 delta, or the pair (u, v).
Formula argument_formula(const Argument& argument);
std::vector<Formula> argument_formulas(std::span<const Argument> arguments);

/// p(arguments).
Formula value_of_blossom(std::span<const Argument> arguments, const std::string& name = "p");

/// 1 + 2t + 4t^2 - t^3.
Formula polynomial_formula(const Polynomial& polynomial, const std::string& variable);

/// P(t) with the given variable.
Formula map_at_variable(const GivenMap& given);

/// The weighted sum; a weight 1 is not written.
Formula combination(const std::vector<std::pair<Rational, Formula>>& terms);

/// What defines the map: its equation, or its control points as blossom values over their interval.
Display definition_of(const GivenMap& given);

std::size_t degree_of(const PolynomialMap& map);
std::size_t dimension_of(const PolynomialMap& map);

/// The map by its control points: as given, or over [0, 1].
BezierCurve bezier_form(const PolynomialMap& map, const Limits& limits);
/// The map by its coefficients.
PolynomialCurve coefficient_form(const PolynomialMap& map, const Limits& limits);

/// "1, 2 and delta are ..." for the arguments (a^(n-k), b^k).
std::vector<Argument> end_arguments(const Rational& a, const Rational& b, std::size_t n, std::size_t k);

/// A document with what every chapter on one polynomial map has: title, source, map and definition.
/// Errors: `limit_exceeded` for a degree above `page_degree`.
Document begun(const GivenMap& given, std::string title, std::string source);

}  // namespace blossom::worked
