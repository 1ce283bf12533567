#include <blossom/core/spline/knot_removal.hpp>
#include "core_test.hpp"

namespace {

/// The number of orders in which the polynomials on the two sides of a knot agree. Their difference D, of
/// degree n, has a factor (t - knot)^(k+1) if and only if D(t) / (t - knot)^(k+1) is a polynomial of degree n
/// - k - 1, that is, if its differences of order n - k vanish; they are taken at knot + 1, ..., knot + n + 1.
std::size_t orders_of_contact(const textbook::Spline& plain, const Rational& knot) {
    const std::size_t n = plain.degree;
    std::size_t left = 0;
    for (std::size_t i = n; i < plain.points.size(); ++i) {
        if (plain.knots[i] < plain.knots[i + 1] && plain.knots[i + 1] <= knot) left = i;
    }
    const std::size_t right = textbook::span_of(plain, knot);
    for (std::size_t k = 0; k <= n; ++k) {
        std::vector<Coordinates> quotients;
        for (std::size_t i = 1; i <= n + 1; ++i) {
            const Coordinates a = textbook::segment_value(plain, left, knot + Rational(i));
            Coordinates quotient = textbook::segment_value(plain, right, knot + Rational(i));
            for (std::size_t j = 0; j < a.size(); ++j)
                quotient[j] = (quotient[j] - a[j]) / pow(Rational(i), k + 1);
            quotients.push_back(quotient);
        }
        for (std::size_t order = 0; order < n - k; ++order) {
            for (std::size_t i = 0; i + 1 < quotients.size(); ++i) {
                for (std::size_t j = 0; j < quotients[i].size(); ++j)
                    quotients[i][j] = quotients[i + 1][j] - quotients[i][j];
            }
            quotients.pop_back();
        }
        for (const Coordinates& difference : quotients) {
            if (!std::ranges::all_of(difference, &Rational::is_zero)) return k;
        }
    }
    return n + 1;
}

}  // namespace

TEST_CASE("what was inserted is removed again, exactly", "[removal]") {
    Random random(31);
    for (int round = 0; round < 300; ++round) {
        const SplineRecipe recipe =
            spline(random, random.below(7), random.one_in(6) ? Size::any : Size::small);
        const BSplineCurve curve = recipe.curve();
        const std::vector<Rational> knots = insertable(random, curve.knots(), 6);
        BSplineCurve now = insert_knots_boehm(curve, knots);
        for (const Rational& knot : knots) {
            const KnotRemoval removal = remove_knot(now, knot);
            CHECK(removal.removed == 1);
            CHECK_FALSE(removal.obstruction);
            now = removal.curve;
        }
        CHECK(now == curve);
    }
}

TEST_CASE(
    "derose-thm2: a knot of multiplicity m is removed m + k - n times where the segments meet with order k",
    "[removal][derose]") {
    Random random(32);
    for (int round = 0; round < 60; ++round) {
        const SplineRecipe recipe = spline(random, random.below(6));
        BSplineCurve curve = recipe.curve();
        curve = insert_knots_oslo(curve, insertable(random, curve.knots(), 4));
        const Interval domain = curve.knots().domain();
        for (const auto& [knot, multiplicity] : curve.knots().distinct()) {
            if (knot <= domain.a() || domain.b() <= knot) continue;
            const KnotRemoval removal = remove_knot(curve, knot, multiplicity);
            const std::size_t expected =
                multiplicity + orders_of_contact(oracle(curve), knot) - recipe.degree - 1;
            CHECK(removal.removed == std::min(expected, multiplicity));
            CHECK(removal.obstruction.has_value() == (removal.removed < multiplicity));
            CHECK(removal.curve.knots().multiplicity(knot) == multiplicity - removal.removed);
            CHECK(textbook::same_map(oracle(removal.curve), oracle(curve)));
        }
    }
}

TEST_CASE("the obstruction is a window of knots at which the blossoms of both sides differ", "[removal]") {
    const BSplineCurve curve(3, {0, 1, 2, 3, 4, 5, 6, 7}, {{0, 0}, {1, 2}, {3, 3}, {5, 1}, {6, 0}, {8, 2}});
    const KnotRemoval refused = remove_knot(curve, 3);
    CHECK(refused.removed == 0);
    CHECK(refused.curve == curve);
    REQUIRE(refused.obstruction);
    CHECK(refused.obstruction->knots == std::vector<Rational>{4, 5, 6});

    Random random(33);
    std::size_t seen = 0;
    for (int round = 0; round < 200; ++round) {
        const SplineRecipe recipe = spline(random, random.below(6));
        const BSplineCurve whole = recipe.curve();
        const Interval domain = whole.knots().domain();
        for (const auto& [knot, multiplicity] : whole.knots().distinct()) {
            if (knot <= domain.a() || domain.b() <= knot) continue;
            const KnotRemoval removal = remove_knot(whole, knot, multiplicity);
            if (!removal.obstruction) continue;
            const RemovalObstruction& obstruction = *removal.obstruction;
            const std::vector<Argument> arguments(obstruction.knots.begin(), obstruction.knots.end());
            const KnotVector& knots = removal.curve.knots();
            CHECK(obstruction.from_left ==
                  segment_blossom(removal.curve, knots.span_before(knot), arguments));
            CHECK(obstruction.from_right == segment_blossom(removal.curve, knots.span_at(knot), arguments));
            const Coordinates residual = obstruction.residual();
            CHECK_FALSE(std::ranges::all_of(residual, &Rational::is_zero));
            for (std::size_t i = 0; i < residual.size(); ++i) {
                CHECK(residual[i] + obstruction.from_right[i] == obstruction.from_left[i]);
            }
            ++seen;
        }
    }
    CHECK(seen > 200);
}

TEST_CASE("only knots between those that bound the domain can be removed, and only those that are there",
          "[removal]") {
    const BSplineCurve curve(2, {0, 1, 1, 2, 3, 3}, {{0}, {1}, {3}, {2}, {5}});
    CHECK(curve.knots().domain() == Interval(1, 3));
    for (const Rational& knot : {Rational(0), Rational(5, 2), Rational(3)}) {
        const auto refused = failure([&] { remove_knot(curve, knot); });
        REQUIRE(refused);
        CHECK(refused->code() == ErrorCode::bad_knots);
        CHECK(refused->place() == Part::knot);
    }
    const auto often = failure([&] { remove_knot(curve, 2, 2); });
    REQUIRE(often);
    CHECK(often->message() ==
          "the knot 2 occurs 1 times between those that bound the domain; it cannot be removed 2 times");
    CHECK(often->place() == Part::times);
    CHECK(remove_knot(curve, 2, 0).removed == 0);

    const std::vector<Rational> at_ends{1, 3};
    const BSplineCurve full = insert_knots_boehm(curve, at_ends);
    CHECK(remove_knot(remove_knot(full, 1).curve, 3).curve == curve);
    CHECK(failure_code([&] { remove_knot(full, 1, 3); }) == ErrorCode::bad_knots);
}

TEST_CASE("a step of a spline of degree 0 is removed where it is none", "[removal]") {
    const BSplineCurve steps(0, {0, 1, 2, 3}, {{5}, {5}, {7}});
    CHECK(remove_knot(steps, 1).curve == BSplineCurve(0, {0, 2, 3}, {{5}, {7}}));
    const KnotRemoval refused = remove_knot(steps, 2);
    REQUIRE(refused.obstruction);
    CHECK(refused.obstruction->residual() == Coordinates{-2});
}
