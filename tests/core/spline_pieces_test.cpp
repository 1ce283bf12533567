#include <blossom/core/spline/spline_join.hpp>
#include <blossom/core/spline/spline_split.hpp>
#include "core_test.hpp"

namespace {

const Rational third(1, 3);
const Rational half(1, 2);

}  // namespace

TEST_CASE("the segments of the example", "[extraction]") {
    const std::vector<BezierCurve> segments = bezier_segments(example_spline());
    REQUIRE(segments.size() == 3);
    CHECK(segments[0] == BezierCurve(std::vector<Coordinates>{{Rational(7, 6), Rational(11, 6)},
                                                              {Rational(5, 3), Rational(7, 3)},
                                                              {Rational(7, 3), Rational(8, 3)},
                                                              {3, Rational(5, 2)}},
                                     Interval(2, 3)));
    CHECK(segments[2] == BezierCurve(std::vector<Coordinates>{{Rational(29, 6), Rational(7, 6)},
                                                              {Rational(16, 3), Rational(2, 3)},
                                                              {Rational(17, 3), third},
                                                              {Rational(37, 6), half}},
                                     Interval(4, 5)));
    CHECK(segments[1] == sablonniere(example_spline(), 3));
    CHECK(failure_code([] { sablonniere(example_spline(), 1); }) == ErrorCode::outside_domain);
    Limits limits;
    limits.numbers = 23;
    CHECK(failure_code([&] { bezier_segments(example_spline(), limits); }) == ErrorCode::limit_exceeded);
}

TEST_CASE(
    "derose-fig9-sablonniere: the segments are the oracle's polynomials, their points its blossom values",
    "[extraction][derose]") {
    Random random(41);
    for (int round = 0; round < 80; ++round) {
        const SplineRecipe recipe =
            spline(random, random.below(5), random.one_in(5) ? Size::any : Size::small);
        const BSplineCurve curve = recipe.curve();
        const textbook::Spline plain = recipe.oracle();
        const std::size_t shift = plain.knots.size() == recipe.knots.size() ? 0 : 1;
        const auto segments = bezier_segments(curve);
        const auto spans = curve.knots().spans();
        REQUIRE(segments.size() == spans.size());
        for (std::size_t i = 0; i < spans.size(); ++i) {
            const Rational& a = recipe.knots[spans[i]];
            const Rational& b = recipe.knots[spans[i] + 1];
            CHECK(segments[i].interval() == Interval(a, b));
            for (std::size_t k = 0; k <= recipe.degree; ++k) {
                std::vector<Argument> ends(recipe.degree - k, Parameter(a));
                ends.resize(recipe.degree, Parameter(b));
                CHECK(segments[i].control_points()[k] ==
                      textbook::segment_blossom(plain, spans[i] + shift, ends));
            }
            const Rational t = a + (b - a) * Rational(random.between(-9, 9), 7);
            CHECK(textbook::bernstein_value(segments[i].control_points().to_points(), segments[i].interval(),
                                            t) ==
                  textbook::text(textbook::segment_value(plain, spans[i] + shift, t)));
        }
    }
}

TEST_CASE("segments joined over the knots that they came from are the spline again", "[join]") {
    Random random(42);
    for (int round = 0; round < 150; ++round) {
        const SplineRecipe recipe =
            spline(random, random.below(7), random.one_in(6) ? Size::any : Size::small);
        const BSplineCurve curve = recipe.curve();
        std::vector<BezierCurve> segments = bezier_segments(curve);
        CHECK(join(segments, curve.knots()) == curve);
        const BSplineCurve least = join(segments);
        CHECK(textbook::same_map(oracle(least), recipe.oracle()));
        CHECK(least.knots().convention() == KnotConvention::textbook);
        const Interval domain = curve.knots().domain();
        for (const auto& [knot, multiplicity] : least.knots().distinct()) {
            if (domain.a() < knot && knot < domain.b())
                CHECK(multiplicity <= curve.knots().multiplicity(knot));
        }
    }
}

TEST_CASE("joining gives the least multiplicities: none for one polynomial, n + 1 for a jump", "[join]") {
    const auto bezier = [](std::vector<Coordinates> points, Interval interval) {
        return BezierCurve(points, interval);
    };
    const BezierCurve left = bezier({{0}, {1}, {4}}, {0, 1});
    CHECK(join(std::vector{left}).knots().knots() == std::vector<Rational>{0, 0, 0, 1, 1, 1});
    CHECK(join(std::vector{left}).control_points() == std::vector<Coordinates>{{0}, {1}, {4}});
    CHECK(join(std::vector{left, bezier({{4}, {7}, {9}}, {1, 2})}).knots().multiplicity(1) == 1U);
    CHECK(join(std::vector{left, bezier({{4}, {6}, {9}}, {1, 2})}).knots().multiplicity(1) == 2U);
    CHECK(join(std::vector{left, bezier({{5}, {6}, {9}}, {1, 2})}).knots().multiplicity(1) == 3U);
    CHECK(join(std::vector{left, control_points(left, Interval(1, 2))}).knots().multiplicity(1) == 0U);
    CHECK(join(std::vector{left, bezier({{9}, {7}, {4}}, {2, 1})}) ==
          join(std::vector{left, bezier({{4}, {7}, {9}}, {1, 2})}));

    const BSplineCurve mixed = join(std::vector{left, bezier({{4}, {7}}, {1, 2})});
    CHECK(mixed.degree() == 2);
    CHECK(mixed.knots().multiplicity(1) == 2U);
    CHECK(evaluate(mixed, Rational(3, 2)) == Coordinates{Rational(11, 2)});
}

TEST_CASE("curves that are not adjacent, not of one dimension or not smooth enough are not joined",
          "[join]") {
    const BezierCurve left(std::vector<Coordinates>{{0}, {1}, {4}}, Interval(0, 1));
    const BezierCurve right(std::vector<Coordinates>{{4}, {6}, {9}}, Interval(1, 2));
    CHECK(failure_code([] { join(std::vector<BezierCurve>{}); }) == ErrorCode::wrong_arity);
    const auto gap =
        failure([&] { join(std::vector{left, BezierCurve(std::vector<Coordinates>{{4}}, Interval(2, 3))}); });
    REQUIRE(gap);
    CHECK(gap->code() == ErrorCode::not_adjacent);
    CHECK(gap->message() == "the interval [2, 3] of map 1 does not begin where [0, 1] of map 0 ends");
    CHECK(gap->place() == Part::maps / 1 / Part::interval);
    CHECK(failure_code([&] { join(std::vector{right, left}); }) == ErrorCode::not_adjacent);
    const auto dimensions = failure(
        [&] { join(std::vector{left, BezierCurve(std::vector<Coordinates>{{4, 5}}, Interval(1, 2))}); });
    REQUIRE(dimensions);
    CHECK(dimensions->code() == ErrorCode::mismatched_dimensions);
    CHECK(dimensions->place() == Part::maps / 1 / Part::control_points);

    const auto rough =
        failure([&] { join(std::vector{left, right}, KnotVector(2, {0, 0, 0, 1, 2, 2, 2}, 4)); });
    REQUIRE(rough);
    CHECK(rough->code() == ErrorCode::not_continuous);
    CHECK(rough->message() ==
          "multiplicity 1 of the knot 1 in degree 2 needs order 1 of maps 0 and 1. The curves meet with "
          "order 0 at 1, sharing the point but not the tangent: the blossom values at (1, 2) are 7 and 6");
    CHECK(rough->place() == Part::maps / 1);
    CHECK_FALSE(failure([&] { join(std::vector{left, right}, KnotVector(2, {0, 0, 0, 1, 1, 2, 2, 2}, 5)); }));
    CHECK(failure_code([&] { join(std::vector{left, right}, KnotVector(2, {0, 0, 0, 1, 1, 3, 3, 3}, 5)); }) ==
          ErrorCode::bad_knots);
    CHECK(failure_code([&] { join(std::vector{left, right}, KnotVector(1, {0, 0, 1, 2, 2}, 3)); }) ==
          ErrorCode::degree_too_low);
}

TEST_CASE("target knots may be finer, of higher degree, open, and of either convention", "[join]") {
    const BezierCurve left(std::vector<Coordinates>{{0}, {1}, {4}}, Interval(0, 1));
    const BezierCurve right(std::vector<Coordinates>{{4}, {6}, {9}}, Interval(1, 2));
    const std::vector both{left, right};
    const BSplineCurve plain = join(both);
    const Interval domain(0, 2);
    for (const KnotVector& knots : {knots_over(2, {0, 0, Rational(1, 2), 1, 1, 2, 2}, domain),
                                    knots_over(3, {-2, -1, -1, 0, 1, 1, 1, 2, 3, 4, 5}, domain),
                                    knots_over(3, {-1, -1, 0, 1, 1, 1, 2, 3, 4}, domain)}) {
        const BSplineCurve joined = join(both, knots);
        CHECK(joined.knots() == knots);
        CHECK(textbook::same_map(oracle(joined), oracle(plain)));
    }
    CHECK(knots_over(2, {0, 0, 1, 1, 2, 2}, domain).convention() == KnotConvention::polar);
    CHECK(knots_over(2, {0, 0, 0, 1, 1, 2, 2, 2}, domain).convention() == KnotConvention::textbook);
    CHECK(failure_code([&] { knots_over(2, {0, 0, 1, 1, 3, 3}, domain); }) == ErrorCode::bad_knots);
    CHECK(failure_code([&] { knots_over(2, {0, 2}, domain); }) == ErrorCode::bad_knots);
    CHECK(failure_code([&] { knots_over(2, {}, domain); }) == ErrorCode::bad_knots);
}

TEST_CASE(
    "hart-deboor-subdivide: a triple knot at 3.5 splits 0..7 into two curves of 5 points that share one",
    "[split][hart]") {
    const Rational u(7, 2);
    const auto [left, right] = split(example_spline(), u);
    CHECK(left.knots().knots() == std::vector<Rational>{0, 1, 2, 3, u, u, u});
    CHECK(right.knots().knots() == std::vector<Rational>{u, u, u, 4, 5, 6, 7});
    CHECK(left.control_points().size() == 5);
    CHECK(right.control_points().size() == 5);
    CHECK(left.control_points().back() == evaluate(example_spline(), u));
    CHECK(right.control_points().front() == evaluate(example_spline(), u));
}

TEST_CASE("both parts of a split are the curve on their domains", "[split]") {
    Random random(43);
    for (int round = 0; round < 250; ++round) {
        const SplineRecipe recipe = spline(random, random.below(6));
        const BSplineCurve curve = recipe.curve();
        const Interval domain = curve.knots().domain();
        const Rational u = parameter(random, curve.knots());
        if (u == domain.a() || u == domain.b()) {
            CHECK(failure_code([&] { split(curve, u); }) == ErrorCode::outside_domain);
            continue;
        }
        const auto [left, right] = split(curve, u);
        CHECK(left.knots().domain() == Interval(domain.a(), u));
        CHECK(right.knots().domain() == Interval(u, domain.b()));
        CHECK(left.knots().convention() == curve.knots().convention());
        CHECK(right.knots().convention() == curve.knots().convention());
        for (int step = 0; step <= 20; ++step) {
            const Rational t = domain.a() + (domain.b() - domain.a()) * Rational(step, 20);
            if (t != u)
                CHECK(textbook::value(oracle(t < u ? left : right), t) ==
                      textbook::value(recipe.oracle(), t));
        }
        CHECK(textbook::value(oracle(right), u) == textbook::value(recipe.oracle(), u));
        if (curve.knots().multiplicity(u) <= recipe.degree)
            CHECK(left.control_points().back() == right.control_points().front());
        std::vector<BezierCurve> segments = bezier_segments(left);
        const std::vector<BezierCurve> more = bezier_segments(right);
        segments.insert(segments.end(), more.begin(), more.end());
        CHECK(textbook::same_map(oracle(join(segments)), recipe.oracle()));
    }
}
