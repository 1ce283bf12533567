#include <blossom/core/spline/continuity.hpp>
#include "core_test.hpp"

namespace {

/// P + sum_{j > k} e_j (t - s)^j with e_(k+1) not zero: a map that meets P with order k at s.
PolynomialCurve touching(Random& random, const PolynomialCurve& curve, std::size_t k, const Rational& s) {
    Polynomial power = 1;
    const Polynomial factor(std::vector<Rational>{-s, 1});
    std::vector<Polynomial> coordinates;
    for (std::size_t i = 0; i < curve.dimension(); ++i) coordinates.push_back(curve.coordinate(i));
    for (std::size_t j = 0; j <= curve.degree(); ++j) {
        if (j > k) {
            Rational scale = small_rational(random);
            if (j == k + 1 && scale.is_zero()) scale = 1;
            coordinates[random.below(j == k + 1 ? 1 : coordinates.size())] += Polynomial(scale) * power;
        }
        power *= factor;
    }
    return PolynomialCurve(coordinates, curve.degree());
}

}  // namespace

TEST_CASE("derose-ck-def, derose-thm2: the order of contact is that of the derivatives",
          "[continuity][derose]") {
    Random random(51);
    for (int round = 0; round < 300; ++round) {
        const std::size_t n = 1 + random.below(6);
        const PolynomialRecipe recipe = polynomial_map(random, n, Size::small);
        const Rational s = small_rational(random);
        const std::size_t k = random.below(n);
        const PolynomialCurve left = recipe.curve();
        const PolynomialCurve right = touching(random, left, k, s);
        const Contact met = contact(left, right, s);
        CHECK(met.order == static_cast<std::ptrdiff_t>(k));
        for (std::size_t i = 0; i <= n; ++i) {
            const bool equal = derivative(left, i, s) == derivative(right, i, s);
            if (i <= k) CHECK(equal);
            if (i == k + 1) CHECK_FALSE(equal);
        }
        REQUIRE(met.first_difference);
        const BlossomDifference& difference = *met.first_difference;
        CHECK(difference.left == Blossom(left)(difference.arguments));
        CHECK(difference.right == Blossom(right)(difference.arguments));
        CHECK_FALSE(difference.left == difference.right);
        CHECK(std::ranges::count(difference.arguments, Argument(Parameter(s))) ==
              static_cast<std::ptrdiff_t>(n - k - 1));
        CHECK(contact(left, control_points(right, Interval(s, s + 1)), s) == met);
    }
}

TEST_CASE("the order of contact has its name in geometry", "[continuity]") {
    CHECK(contact_text(-1, 3) == "The curves do not meet at 3");
    CHECK(contact_text(0, 3) == "The curves meet with order 0 at 3, sharing the point but not the tangent");
    CHECK(contact_text(1, 3) ==
          "The curves meet with order 1 at 3, sharing the tangent but not the osculating parabola");
    CHECK(contact_text(2, Rational(1, 2)) ==
          "The curves meet with order 2 at 1/2, sharing the osculating parabola but not the osculating curve "
          "of "
          "degree 3");
}

TEST_CASE("curves that are one polynomial, do not meet, or differ in degree or dimension", "[continuity]") {
    const PolynomialCurve line(std::vector<Coordinates>{{0, 1}, {1, 2}});
    const PolynomialCurve raised(std::vector<Coordinates>{{0, 1}, {1, 2}, {0, 0}, {0, 0}});
    CHECK(contact(line, raised, 7).is_infinite());
    CHECK_FALSE(contact(line, raised, 7).first_difference);
    const PolynomialCurve apart(std::vector<Coordinates>{{0, 2}, {1, 2}});
    const Contact none = contact(line, apart, 0);
    CHECK(none.order == -1);
    CHECK(to_string(none, 0) ==
          "The curves do not meet at 0: the blossom values at (0) are (0, 1) and (0, 2)");
    CHECK(to_string(contact(line, raised, 7), 7) == "The curves are the same polynomial at 7");
    const PolynomialCurve scalar(Polynomial(1));
    CHECK(failure_code([&] { contact(line, scalar, 0); }) == ErrorCode::mismatched_dimensions);
    CHECK(contact(PolynomialCurve(Polynomial(1)), PolynomialCurve(Polynomial::monomial(3) + Polynomial(1)), 0)
              .order == 2);
}

TEST_CASE("derose-46-c2cond: over simple knots cubic segments meet with order 2, and 2 exactly",
          "[continuity][derose]") {
    const BSplineCurve curve(3, {0, 1, 2, 3, 4, 5, 6, 7}, {{0, 0}, {1, 2}, {3, 3}, {5, 1}, {6, 0}, {8, 2}});
    CHECK(contact(curve, 3).order == 2);
    CHECK(contact(curve, 4).order == 2);
    CHECK(contact(curve, Rational(7, 2)).is_infinite());
    for (const auto& [u, v] : {std::pair<Rational, Rational>{0, 9}, {Rational(1, 3), -4}, {3, 5}}) {
        const std::vector<Argument> asked{Parameter(3), Parameter(u), Parameter(v)};
        CHECK(segment_blossom(curve, 2, asked) == segment_blossom(curve, 3, asked));
    }
    const auto end = failure([&] { contact(curve, 2); });
    REQUIRE(end);
    CHECK(end->code() == ErrorCode::outside_domain);
    CHECK(end->place() == Part::at);
    CHECK(failure_code([&] { contact(curve, 5); }) == ErrorCode::outside_domain);
    CHECK(failure_code([&] { contact(curve, 6); }) == ErrorCode::outside_domain);
}

TEST_CASE("derose-46-general-cd1: at a knot of multiplicity m segments of degree d meet with order d - m",
          "[continuity][derose]") {
    Random random(53);
    std::size_t exactly = 0;
    for (int round = 0; round < 200; ++round) {
        const SplineRecipe recipe = spline(random, random.below(7));
        const BSplineCurve curve = recipe.curve();
        const Interval domain = curve.knots().domain();
        for (const auto& [knot, multiplicity] : curve.knots().distinct()) {
            if (knot <= domain.a() || domain.b() <= knot) continue;
            const Contact met = contact(curve, knot);
            const auto least =
                static_cast<std::ptrdiff_t>(recipe.degree) - static_cast<std::ptrdiff_t>(multiplicity);
            if (!met.is_infinite()) CHECK(*met.order >= least);
            exactly += met.order == least ? 1U : 0U;
            std::vector<Argument> asked = arguments(random, recipe.degree, Size::small);
            if (multiplicity > recipe.degree) continue;
            std::fill_n(asked.begin(), multiplicity, Parameter(knot));
            CHECK(segment_blossom(curve, curve.knots().span_before(knot), asked) ==
                  segment_blossom(curve, curve.knots().span_at(knot), asked));
        }
    }
    CHECK(exactly > 300);
}
