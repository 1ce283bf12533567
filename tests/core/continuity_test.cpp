#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/derivative.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/continuity.hpp>
#include <blossom/core/spline/de_boor.hpp>

#include <algorithm>

#include "support/failure.hpp"
#include "support/map_printing.hpp"
#include "support/number_generators.hpp"
#include "support/spline_generators.hpp"

using namespace blossom;
using namespace blossom::testing;

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

/// The joint of the two pieces, knots 0..6, with the points 0, 0, 0, 0, 1: t_i = 1, t_(i+2) = 3.
BSplineCurve two_pieces() { return {3, {0, 1, 2, 3, 4, 5, 6}, {{0}, {0}, {0}, {0}, {1}}}; }

PolynomialMap piece(const BSplineCurve& curve, std::size_t span) {
    return monomial_form(sablonniere(curve, span));
}

std::vector<Argument> points(std::initializer_list<Rational> values) {
    return {values.begin(), values.end()};
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

TEST_CASE("derose-thm2: blossoms with n - k arguments s agree for all others exactly up to the order",
          "[continuity][derose]") {
    Random random(52);
    for (int round = 0; round < 150; ++round) {
        const std::size_t n = 1 + random.below(6);
        const PolynomialCurve left = polynomial_map(random, n, Size::small).curve();
        const Rational s = small_rational(random);
        const std::size_t k = random.below(n);
        const PolynomialCurve right = touching(random, left, k, s);
        for (std::size_t others = 0; others <= k; ++others) {
            std::vector<Argument> asked = arguments(random, others, Size::small);
            asked.resize(n, Parameter(s));
            CHECK(Blossom(left)(asked) == Blossom(right)(asked));
        }
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
        CHECK(segment_blossom(curve, 2, points({3, u, v})) == segment_blossom(curve, 3, points({3, u, v})));
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

TEST_CASE(
    "derose-46-three-agreements: agreement at the three windows around t_(i+2) makes a difference c (t - "
    "t_(i+2))^3",
    "[continuity][derose]") {
    Random random(54);
    for (int round = 0; round < 100; ++round) {
        std::vector<Rational> t{small_rational(random)};
        while (t.size() < 5) t.push_back(t.back() + Rational(random.between(1, 9), random.between(1, 5)));
        const PolynomialCurve left = polynomial_map(random, 3, Size::small).curve();
        std::vector<Rational> knots{t[0], t[1], t[2], t[3], t[4], t[4] + 1};
        const ProgressiveCurve of_left = progressive_form(left, knots);
        std::vector<Coordinates> values = of_left.control_points().to_points();
        values.back().front() += 1;
        const ProgressiveCurve of_right(knots, values);
        CHECK(contact(left, control_points(of_right, Interval(t[2], t[3])), t[2]).order == 2);
    }
}

TEST_CASE("derose-46-c2-location: the segments meet with order 2 at t_(i+2), and do not meet at t_i",
          "[continuity][derose]") {
    const BSplineCurve curve = two_pieces();
    const PolynomialMap left = piece(curve, 2);
    const PolynomialMap right = piece(curve, 3);
    CHECK(contact(left, right, 3).order == 2);
    const Contact printed = contact(left, right, 1);
    CHECK(printed.order == -1);
    REQUIRE(printed.first_difference);
    CHECK(printed.first_difference->left == Coordinates{0});
    CHECK(printed.first_difference->right == Coordinates{Rational(-4, 3)});
    const Polynomial cubed = pow(Polynomial(std::vector<Rational>{-3, 1}), 3);
    CHECK(std::get<PolynomialCurve>(right).coordinate(0) - std::get<PolynomialCurve>(left).coordinate(0) ==
          cubed * Polynomial(Rational(1, 6)));
}

TEST_CASE("derose-46-five-points: two segments have five control points, three of them in common",
          "[continuity][derose]") {
    Random random(55);
    for (int round = 0; round < 60; ++round) {
        const std::vector<std::size_t> one{1};
        const SplineRecipe recipe = spline(random, 3, one, KnotConvention::polar, Ends::open, Ends::open);
        const textbook::Spline plain = recipe.oracle();
        REQUIRE(recipe.points.size() == 5);
        const auto window = [&](std::size_t j) {
            return std::vector<Argument>(recipe.knots.begin() + static_cast<std::ptrdiff_t>(j),
                                         recipe.knots.begin() + static_cast<std::ptrdiff_t>(j + 3));
        };
        for (std::size_t j = 0; j < 5; ++j) {
            if (j < 4)
                CHECK(textbook::segment_blossom(plain, 3, window(j)) ==
                      segment_blossom(recipe.curve(), 2, window(j)));
            if (j < 4) CHECK(segment_blossom(recipe.curve(), 2, window(j)) == recipe.points[j]);
            if (j > 0) CHECK(segment_blossom(recipe.curve(), 3, window(j)) == recipe.points[j]);
        }
    }
}

TEST_CASE("derose-46-next-segment, derose-46-cubic-scheme: m - 2 segments on [t_2, t_m] from points v_0..v_m",
          "[continuity][derose]") {
    Random random(56);
    for (std::size_t m = 3; m <= 8; ++m) {
        const std::vector<std::size_t> inner(m - 3, 1);
        const SplineRecipe recipe = spline(random, 3, inner, KnotConvention::polar, Ends::open, Ends::open);
        const BSplineCurve curve = recipe.curve();
        REQUIRE(recipe.points.size() == m + 1);
        CHECK(recipe.knots.size() == m + 3);
        CHECK(curve.knots().domain() == Interval(recipe.knots[2], recipe.knots[m]));
        for (const std::size_t span : curve.knots().spans()) {
            const std::size_t i = span - 2;
            for (std::size_t j = 0; j < 4; ++j) {
                const auto& t = recipe.knots;
                const auto value =
                    segment_blossom(curve, span, points({t[i + j], t[i + j + 1], t[i + j + 2]}));
                CHECK(value == recipe.points[i + j]);
                CHECK(value == textbook::segment_blossom(recipe.oracle(), span + 1,
                                                         points({t[i + j], t[i + j + 1], t[i + j + 2]})));
            }
        }
        for (std::size_t i = 3; i < m; ++i) {
            const Contact met = contact(curve, recipe.knots[i]);
            CHECK((met.is_infinite() || *met.order >= 2));
        }
    }
}

TEST_CASE("derose-46-piecewise-blossom: the printed rule has two answers at (2, 4, 4), 0 and -1/6",
          "[continuity][derose]") {
    const BSplineCurve curve = two_pieces();
    CHECK(segment_blossom(curve, 2, points({2, 4, 4})) == Coordinates{0});
    CHECK(segment_blossom(curve, 3, points({2, 4, 4})) == Coordinates{Rational(-1, 6)});
    CHECK(textbook::segment_blossom(oracle(curve), 4, points({2, 4, 4})) == Coordinates{Rational(-1, 6)});
    CHECK(segment_blossom(curve, 2, points({2, 3, 4})) == segment_blossom(curve, 3, points({2, 3, 4})));
}
