// De Boor's triangle and knot insertion over rational knots, with numbers near the limits of words.

#include <blossom/core/spline/de_boor.hpp>
#include <blossom/core/spline/knot_insertion.hpp>

#include "each_case.hpp"
#include "support/spline_generators.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

Rational rational_near(Random& random, std::size_t bits) {
    return {number_near(random, bits), abs(number_near(random, bits)) + 1};
}

/// The knots of a random spline under an increasing map that gives each knot its own denominator.
SplineRecipe rational_spline(Random& random, std::size_t bits) {
    SplineRecipe recipe = spline(random, random.below(6));
    const Rational scale = abs(rational_near(random, bits)) + Rational(1, 7);
    for (Rational& knot : recipe.knots) knot = scale * (knot + knot / (abs(knot) + 3));
    for (Coordinates& point : recipe.points)
        for (Rational& number : point) number *= rational_near(random, bits);
    return recipe;
}

}  // namespace

TEST_CASE("combinations: numbers near the limits of words", "[differential]") {
    each_case("combinations", [&](Random& random) {
        const std::size_t bits = random.below(random.one_in(3) ? 130 : 34);
        const Rational a = rational_near(random, bits);
        Rational b = rational_near(random, bits);
        if (random.one_in(3)) b = Rational(b.numerator(), a.denominator());
        if (random.one_in(8)) b = a;
        const Integer left = number_near(random, bits);
        const Integer right = number_near(random, bits);
        Integer divisor = number_near(random, bits);
        if (divisor.is_zero()) divisor = -1;
        CHECK(combination(left, a, right, b, divisor) ==
              (Rational(left) * a + Rational(right) * b) / Rational(divisor));
    });
}

TEST_CASE("de Boor's triangle: knots and points near the limits of words", "[differential]") {
    each_case("de Boor's triangle", [&](Random& random) {
        const SplineRecipe recipe = rational_spline(random, random.below(random.one_in(4) ? 62 : 12));
        const BSplineCurve curve = recipe.curve();
        const textbook::Spline expected = recipe.oracle();
        for (int i = 0; i < 3; ++i) {
            const Rational t = parameter(random, curve.knots());
            CHECK(de_boor(curve, t) == textbook::value(expected, t));
        }
    });
}

TEST_CASE("inserted knots: knots and points near the limits of words", "[differential]") {
    each_case("inserted knots", [&](Random& random) {
        const SplineRecipe recipe = rational_spline(random, random.below(random.one_in(4) ? 62 : 12));
        const BSplineCurve curve = recipe.curve();
        const std::vector<Rational> knots = insertable(random, curve.knots(), 1 + random.below(40));
        const BSplineCurve refined = insert_knots(curve, knots);
        CHECK(refined == insert_knots_boehm(curve, knots));
        CHECK(refined == insert_knots_oslo(curve, knots));
        const textbook::Spline before = recipe.oracle();
        const textbook::Spline after = oracle(refined);
        for (int i = 0; i < 3; ++i) {
            const Rational t = parameter(random, refined.knots());
            CHECK(textbook::value(after, t) == textbook::value(before, t));
        }
    });
}
