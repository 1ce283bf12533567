#pragma once

#include <blossom/core/algebra/polynomial.hpp>
#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/polynomial_curve.hpp>

#include <cstddef>
#include <vector>

#include "random.hpp"

namespace blossom::testing {

/// The size of the numbers of a map or an argument.
enum class Size {
    small,  ///< `small_rational`
    any,    ///< `rational`, digits of every size
};

/// A polynomial map as the numbers from which it was made, so that an oracle does not need the map.
struct PolynomialRecipe {
    std::vector<Coordinates>
        coefficients;    ///< at most degree + 1 of them; a quarter of all coefficients are zero
    std::size_t degree;  ///< formal; above the actual degree in a third of the cases

    std::size_t dimension() const { return coefficients.front().size(); }
    PolynomialCurve curve() const { return PolynomialCurve(coefficients, degree); }
};

struct BezierRecipe {
    std::vector<Coordinates> control_points;
    Interval interval;

    std::size_t degree() const { return control_points.size() - 1; }
    std::size_t dimension() const { return control_points.front().size(); }
    BezierCurve curve() const { return BezierCurve(control_points, interval); }
};

Rational number(Random& random, Size size);
/// 1 to 3 coordinates.
PolynomialRecipe polynomial_map(Random& random, std::size_t degree, Size size);
BezierRecipe bezier_map(Random& random, std::size_t degree, Size size);
/// A polynomial or Bezier curve.
PolynomialMap any_map(Random& random, std::size_t degree, Size size);
/// [0, 1] in a quarter of the cases, reversed in about half of the others.
Interval interval(Random& random, Size size);
/// An element of Q[t] of at most this degree, sometimes zero.
Polynomial polynomial(Random& random, std::size_t degree, Size size);

Parameter point(Random& random, Size size);
/// Among 8 arguments, 4 are points, 2 vectors, and 2 pairs of any mass; 0, 1 and delta occur.
Argument argument(Random& random, Size size);
/// Each argument after the first repeats an earlier one in a third of the cases.
std::vector<Argument> arguments(Random& random, std::size_t n, Size size);
std::vector<Parameter> points(Random& random, std::size_t n, Size size);

/// a x + b y.
Coordinates combined(const Rational& a, const Coordinates& x, const Rational& b, const Coordinates& y);

}  // namespace blossom::testing
