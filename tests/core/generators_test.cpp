#include "core_test.hpp"

// The generators of maps and arguments must produce the corners that the other tests rely on.

TEST_CASE("polynomial maps of every dimension, often of a formal degree above the actual one",
          "[generators]") {
    Random random(101);
    int dimensions[4] = {};
    int raised = 0;
    int constant = 0;
    int huge = 0;
    for (int i = 0; i < 1200; ++i) {
        const PolynomialRecipe recipe = polynomial_map(random, 4, Size::any);
        const PolynomialCurve curve = recipe.curve();
        CHECK(curve.degree() == 4);
        ++dimensions[recipe.dimension()];
        raised += curve.actual_degree() < 4;
        constant += curve.actual_degree() == 0;
        huge += std::ranges::any_of(recipe.coefficients, [](const Coordinates& point) {
            return point.front().denominator().bit_length() > 64;
        });
    }
    CHECK(dimensions[0] == 0);
    CHECK(std::min({dimensions[1], dimensions[2], dimensions[3]}) > 340);
    CHECK(raised > 330);
    CHECK(raised < 700);
    CHECK(constant > 40);
    CHECK(huge > 60);
}

TEST_CASE("intervals are reversed about as often as not", "[generators]") {
    Random random(102);
    int unit = 0;
    int reversed = 0;
    int reversed_unit = 0;
    int fractions = 0;
    for (int i = 0; i < 1200; ++i) {
        const Interval chosen = interval(random, Size::small);
        unit += chosen == Interval();
        reversed += chosen.b() < chosen.a();
        reversed_unit += chosen == Interval(1, 0);
        fractions += !chosen.a().is_integer() && !chosen.b().is_integer();
    }
    CHECK(unit > 240);
    CHECK(reversed > 420);
    CHECK(reversed < 680);
    CHECK(reversed_unit > 100);
    CHECK(fractions > 200);
}

TEST_CASE("arguments are points, vectors and pairs, and repeat", "[generators]") {
    Random random(103);
    int points = 0;
    int vectors = 0;
    int pairs = 0;
    int deltas = 0;
    int repeated = 0;
    int zeros = 0;
    for (int i = 0; i < 1000; ++i) {
        const std::vector<Argument> chosen = arguments(random, 4, Size::small);
        REQUIRE(chosen.size() == 4);
        for (const Argument& argument : chosen) {
            points += argument.mass == Rational(1);
            vectors += argument.mass.is_zero();
            pairs += !argument.mass.is_zero() && argument.mass != Rational(1);
            deltas += argument == Argument(delta);
            zeros += argument.u.is_zero() && argument.mass.is_zero();
        }
        for (std::size_t k = 1; k < 4; ++k) {
            if (std::find(chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(k), chosen[k]) !=
                chosen.begin() + static_cast<std::ptrdiff_t>(k)) {
                ++repeated;
                break;
            }
        }
    }
    CHECK(points > 1800);
    CHECK(vectors > 900);
    CHECK(pairs > 600);
    CHECK(deltas > 250);
    CHECK(repeated > 600);
    CHECK(repeated < 950);
    CHECK(zeros > 10);
}

TEST_CASE("polynomials of every degree, zero too", "[generators]") {
    Random random(104);
    int degrees[6] = {};
    int zeros = 0;
    for (int i = 0; i < 1200; ++i) {
        const Polynomial chosen = polynomial(random, 5, Size::small);
        REQUIRE(chosen.degree() <= 5);
        ++degrees[chosen.degree()];
        zeros += chosen.is_zero();
    }
    CHECK(zeros > 150);
    for (const int count : degrees) CHECK(count > 80);
}
