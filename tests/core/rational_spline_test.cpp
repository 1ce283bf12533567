#include <blossom/core/nurbs/rational_spline.hpp>
#include "core_test.hpp"

#include <blossom/core/spline/continuity.hpp>
#include <blossom/core/spline/spline_elevation.hpp>

namespace {

/// A random spline with positive weights.
SplineRecipe weighted_spline(Random& random, std::size_t degree) {
    SplineRecipe recipe = spline(random, degree);
    for (Coordinates& point : recipe.points) {
        const Rational weight = 1 + abs(number(random, Size::small));
        for (Rational& coordinate : point) coordinate *= weight;
        point.push_back(weight);
    }
    return recipe;
}

/// The oracle's value divided by its weight.
Coordinates divided_value(const SplineRecipe& recipe, const Rational& t) {
    Coordinates value = textbook::value(recipe.oracle(), t);
    for (Rational& coordinate : value) coordinate /= value.back();
    value.pop_back();
    return value;
}

/// The first derivative of A / w by its definition on polynomials: (A' w - A w') / w^2.
Coordinates first_derivative(const BSplineCurve& curve, const Rational& t) {
    const PolynomialCurve piece = monomial_form(sablonniere(curve, curve.knots().span_at(t)));
    const Polynomial weight = piece.coordinate(piece.dimension() - 1);
    Coordinates result;
    for (std::size_t j = 0; j + 1 < piece.dimension(); ++j) {
        const Polynomial a = piece.coordinate(j);
        result.push_back((derivative(a)(t) * weight(t) - a(t) * derivative(weight)(t)) /
                         (weight(t) * weight(t)));
    }
    return result;
}

}  // namespace

TEST_CASE("a rational spline is the quotient of its coordinates, before and after insertion and raising",
          "[rational_spline]") {
    Random random(521);
    for (int round = 0; round < 60; ++round) {
        const SplineRecipe recipe = weighted_spline(random, random.below(5));
        const BSplineCurve curve = recipe.curve();
        const Rational t = parameter(random, curve.knots());
        const Coordinates expected = divided_value(recipe, t);
        CHECK(rational_derivative(curve, 0, t) == expected);
        CHECK(rational_derivative(insert_knots_boehm(curve, insertable(random, curve.knots(), 3)), 0, t) ==
              expected);
        CHECK(rational_derivative(elevate(curve, 1), 0, t) == expected);
    }
}

TEST_CASE("derivatives of rational splines, as values and as splines", "[rational_spline]") {
    Random random(522);
    for (int round = 0; round < 40; ++round) {
        const SplineRecipe recipe = weighted_spline(random, random.below(4));
        const BSplineCurve curve = recipe.curve();
        const BSplineCurve first = rational_derivative_curve(curve, 1);
        const BSplineCurve second = rational_derivative_curve(curve, 2);
        CHECK(first.degree() == 2 * curve.degree());
        for (int i = 0; i < 3; ++i) {
            const Rational t = parameter(random, curve.knots());
            CHECK(rational_derivative(curve, 1, t) == first_derivative(curve, t));
            CHECK(projected(evaluate(first, t)) == first_derivative(curve, t));
            CHECK(projected(evaluate(second, t)) == rational_derivative(curve, 2, t));
            CHECK(first_derivative(first, t) == rational_derivative(curve, 2, t));
        }
    }
}

TEST_CASE("the contact of rational maps is that of the quotients, not of the homogeneous points",
          "[rational_spline]") {
    const PolynomialCurve line(std::vector<Polynomial>{Polynomial::monomial(1), Polynomial(1)});
    const Polynomial factor = Polynomial(2) + Polynomial::monomial(3);
    const PolynomialCurve same(std::vector<Polynomial>{Polynomial::monomial(1) * factor, factor});
    CHECK_FALSE(projected_contact(line, same, 1).order);
    CHECK(contact(line, same, 1).order == -1);
    const PolynomialCurve parabola(std::vector<Polynomial>{Polynomial::monomial(2), Polynomial(1)});
    const ProjectedContact touching = projected_contact(line, parabola, 1);
    CHECK(touching.order == 0);
    CHECK(touching.first_difference->first == Coordinates{1});
    CHECK(touching.first_difference->second == Coordinates{2});
    CHECK(projected_contact(line, parabola, 3).order == -1);
    CHECK(failure_code([&] { projected_contact(line, PolynomialCurve(std::vector<Polynomial>{1, 0}), 0); }) ==
          ErrorCode::zero_weight);
    CHECK(failure_code([&] { projected_contact(line, PolynomialCurve(Polynomial(1)), 0); }) ==
          ErrorCode::mismatched_dimensions);
}

TEST_CASE("at its knots a rational spline is at least as smooth as its multiplicities say",
          "[rational_spline]") {
    Random random(523);
    for (int round = 0; round < 30; ++round) {
        const BSplineCurve curve = weighted_spline(random, 1 + random.below(3)).curve();
        const Interval domain = curve.knots().domain();
        for (const auto& [knot, multiplicity] : curve.knots().distinct()) {
            if (knot <= domain.a() || domain.b() <= knot) continue;
            const ProjectedContact found = projected_contact(curve, knot);
            if (!found.order) continue;
            const auto k = *found.order;
            CHECK(k + static_cast<std::ptrdiff_t>(multiplicity) >=
                  static_cast<std::ptrdiff_t>(curve.degree()));
            CHECK(found.first_difference->second ==
                  rational_derivative(curve, static_cast<std::size_t>(k + 1), knot));
            CHECK(found.first_difference->first != found.first_difference->second);
        }
    }
    const BSplineCurve curve(1, {0, 0, 1, 1}, {{1, 1}, {2, 2}});
    CHECK(failure_code([&] { projected_contact(curve, 1); }) == ErrorCode::outside_domain);
}

TEST_CASE("the quotient rule needs a value and a weight", "[rational_curve]") {
    const auto at_infinity = [](std::span<const std::size_t>) { return Coordinates{1, 0}; };
    CHECK(failure_code([&] { quotient_rule({}, at_infinity); }) == ErrorCode::zero_weight);
    const PolynomialCurve curve(std::vector<Polynomial>{1, 0});
    CHECK(failure_code([&] { rational_derivative_map(curve, 1); }) == ErrorCode::zero_weight);
    Limits limits;
    limits.degree = 5;
    const PolynomialCurve quadratic(std::vector<Polynomial>{1, Polynomial::monomial(2)});
    CHECK(failure_code([&] { rational_derivative_map(quadratic, 2, limits); }) == ErrorCode::limit_exceeded);
}
