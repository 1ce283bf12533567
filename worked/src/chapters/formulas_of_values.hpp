#pragma once

#include <blossom/core/algebra/polynomial.hpp>
#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/worked/chapters.hpp>

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace blossom::worked {

/// A number, or a tuple of several numbers.
Formula point_formula(const Coordinates& point);

/// 2, delta, 3 delta, or the pair (u, v).
Formula argument_formula(const Argument& argument);
std::vector<Formula> argument_formulas(std::span<const Argument> arguments);

/// p(arguments).
Formula value_of_blossom(std::span<const Argument> arguments, const std::string& name = "p");

/// The formula of a blossom value at given arguments.
using Naming = std::function<Formula(std::span<const Argument>)>;
Naming named_by(std::string blossom);

/// 1 + 2t + 4t^2 - t^3.
Formula polynomial_formula(const Polynomial& polynomial, const std::string& variable);

/// P(t) with the given variable.
Formula map_at_variable(const GivenMap& given);

/// The weighted sum; a weight 1 is not written.
Formula combination(const std::vector<std::pair<Rational, Formula>>& terms);

/// The definition of the map: its equation, or its control points as blossom values over their interval.
Display definition_of(const GivenMap& given);

/// The map by its control points: as given, or over [0, 1].
BezierCurve bezier_form(const PolynomialMap& map, const Limits& limits);

/// (a^(n-k), b^k) for the interval [a, b].
std::vector<Argument> end_arguments(const Interval& interval, std::size_t n, std::size_t k);
/// The arguments at which the blossom is control point k.
std::vector<Argument> end_arguments(const BezierCurve& curve, std::size_t k);

/// p(a^(n-k), b^k) = P_k for all control points.
std::vector<Formula> control_point_equations(const BezierCurve& curve, const Naming& name = named_by("p"));

/// The equation of the map by its coefficients, for a check: P(t) = ....
Formula polynomial_equation(const PolynomialMap& map, const std::string& variable, const Limits& limits);

/// The division of the first coordinates by the last: its inverse times a point.
Formula division(const Coordinates& homogeneous);

/// The beginning of a document on one polynomial map: title, source, map and definition.
/// Errors: `limit_exceeded` for a degree above `page_degree`.
Document begun(const GivenMap& given, std::string title, std::string source);

}  // namespace blossom::worked
