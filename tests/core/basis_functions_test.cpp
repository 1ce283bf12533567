#include <blossom/core/spline/basis_functions.hpp>
#include <blossom/core/spline/greville.hpp>
#include "core_test.hpp"

TEST_CASE("basis functions are the polynomials of the Cox-de Boor recursion", "[basis]") {
    Random random(61);
    for (int round = 0; round < 120; ++round) {
        const SplineRecipe recipe = spline(random, random.below(6));
        const KnotVector knots = recipe.curve().knots();
        const textbook::Spline plain = recipe.oracle();
        const std::size_t shift = plain.knots.size() == recipe.knots.size() ? 0 : 1;
        std::vector<std::vector<PolynomialPiece>> functions;
        for (std::size_t j = 0; j < knots.points(); ++j) functions.push_back(basis_function(knots, j));
        for (const std::size_t span : knots.spans()) {
            Polynomial sum;
            for (std::size_t j = 0; j < knots.points(); ++j) {
                const auto piece = std::ranges::find(functions[j], span, &PolynomialPiece::span);
                const Polynomial polynomial = piece == functions[j].end() ? Polynomial() : piece->polynomial;
                if (piece != functions[j].end())
                    CHECK(piece->interval == Interval(knots[span], knots[span + 1]));
                const Rational t = small_rational(random);
                CHECK(polynomial(t) == textbook::basis_polynomials(plain, span + shift, t)[j]);
                CHECK(polynomial.degree() <= recipe.degree);
                sum += polynomial;
            }
            CHECK(sum == Polynomial(1));
        }
        const Rational t = parameter(random, knots);
        const BasisValues values = basis_values(knots, t);
        const auto expected = textbook::basis_polynomials(plain, textbook::span_of(plain, t), t);
        REQUIRE(values.values.size() == recipe.degree + 1);
        for (std::size_t i = 0; i <= recipe.degree; ++i)
            CHECK(values.values[i] == expected[values.first_point + i]);
    }
}

TEST_CASE("a quadratic basis function over 0, 1, 2, 3 is t^2/2, its middle and (3 - t)^2/2", "[basis]") {
    const KnotVector knots(2, {-2, -1, 0, 1, 2, 3, 4, 5}, 5);
    const auto pieces = basis_function(knots, 2);
    REQUIRE(pieces.size() == 3);
    const Rational half(1, 2);
    CHECK(pieces[0].polynomial == Polynomial(std::vector<Rational>{0, 0, half}));
    CHECK(pieces[1].polynomial == Polynomial(std::vector<Rational>{-Rational(3, 2), 3, -1}));
    CHECK(pieces[2].polynomial == Polynomial(std::vector<Rational>{Rational(9, 2), -3, half}));
    CHECK(basis_function(knots, 0).size() == 1);
    CHECK(failure_code([&] { basis_function(knots, 5); }) == ErrorCode::wrong_arity);
}

TEST_CASE("the Greville abscissae are the control points of the identity map", "[greville]") {
    Random random(62);
    for (int round = 0; round < 100; ++round) {
        const SplineRecipe recipe = spline(random, 1 + random.below(6));
        const KnotVector knots = recipe.curve().knots();
        std::vector<Coordinates> points;
        for (const Rational& abscissa : greville_abscissae(knots)) points.push_back({abscissa});
        const BSplineCurve identity(knots, points);
        const Rational t = parameter(random, knots);
        CHECK(textbook::value(oracle(identity), t) == Coordinates{t});
    }
    CHECK(greville_abscissae(KnotVector(3, {0, 0, 0, 0, 1, 2, 2, 2, 2}, 5)) ==
          std::vector<Rational>{0, Rational(1, 3), 1, Rational(5, 3), 2});
    CHECK(failure_code([] { greville_abscissae(KnotVector(0, {0, 1}, 1)); }) == ErrorCode::degree_too_low);
}
