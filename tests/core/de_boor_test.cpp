#include <blossom/core/spline/de_boor.hpp>

#include "support/failure.hpp"
#include "support/map_printing.hpp"
#include "support/spline_generators.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

BSplineCurve example() {
    return {3, {0, 1, 2, 3, 4, 5, 6, 7}, {{0, 0}, {1, 2}, {3, 3}, {5, 1}, {6, 0}, {8, 2}}};
}

std::size_t textbook_span(const BSplineCurve& curve, std::size_t span) {
    return span + (curve.knots().convention() == KnotConvention::textbook ? 0 : 1);
}

/// The k-th derivative of the oracle's polynomial of a span.
Coordinates derivative_of_oracle(const textbook::Spline& plain, std::size_t span, std::size_t order,
                                 const Rational& t) {
    std::vector<Argument> arguments(plain.degree - order, Parameter(t));
    arguments.resize(plain.degree, delta);
    Coordinates value = textbook::segment_blossom(plain, span, arguments);
    for (Rational& coordinate : value) {
        for (std::size_t i = 0; i < order; ++i) coordinate *= Rational(plain.degree - i);
    }
    return value;
}

}  // namespace

TEST_CASE("a spline is evaluated at the ends and inside of its domain", "[de_boor]") {
    const BSplineCurve curve = example();
    CHECK(evaluate(curve, 2) == Coordinates{Rational(7, 6), Rational(11, 6)});
    CHECK(evaluate(curve, Rational(7, 2)) == Coordinates{Rational(191, 48), Rational(47, 24)});
    CHECK(evaluate(curve, 5) == Coordinates{Rational(37, 6), Rational(1, 2)});
    CHECK(failure_code([&] { evaluate(curve, Rational(11, 2)); }) == ErrorCode::outside_domain);
    CHECK(failure_code([&] { derivative(curve, 1, 1); }) == ErrorCode::outside_domain);
}

TEST_CASE("the blossom of a segment is asked for by its span", "[de_boor]") {
    const BSplineCurve curve = example();
    const std::vector<Argument> arguments{Parameter(3), Parameter(Rational(7, 2)), Parameter(4)};
    CHECK(segment_blossom(curve, 3, arguments) == Coordinates{4, 2});
    CHECK(failure_code([&] { segment_blossom(curve, 5, arguments); }) == ErrorCode::outside_domain);
    const auto arity = failure([&] { segment_blossom(curve, 3, std::span(arguments).first(2)); });
    REQUIRE(arity);
    CHECK(arity->code() == ErrorCode::wrong_arity);
    CHECK(arity->place() == Part::arguments);
    CHECK(failure_code([&] { only_span(curve.knots()); }) == ErrorCode::outside_domain);
    CHECK(only_span(KnotVector(2, {0, 0, 1, 1}, 3)) == 1U);
}

TEST_CASE("derose-46-deboor: de Boor's algorithm gives the value of the Cox-de Boor recursion", "[de_boor]") {
    Random random(3);
    for (int round = 0; round < 400; ++round) {
        const SplineRecipe recipe =
            spline(random, random.below(7), random.one_in(4) ? Size::any : Size::small);
        const BSplineCurve curve = recipe.curve();
        const Rational t = parameter(random, curve.knots());
        CHECK(de_boor(curve, t) == textbook::value(recipe.oracle(), t));
    }
}

TEST_CASE("the blossom of every segment is that of the oracle's polynomial, at points, vectors and pairs",
          "[de_boor]") {
    Random random(4);
    for (int round = 0; round < 70; ++round) {
        const SplineRecipe recipe = spline(random, random.below(6));
        const BSplineCurve curve = recipe.curve();
        const textbook::Spline plain = recipe.oracle();
        for (const std::size_t span : curve.knots().spans()) {
            const std::vector<Argument> asked = arguments(random, recipe.degree, Size::small);
            const Coordinates expected = textbook::segment_blossom(plain, textbook_span(curve, span), asked);
            CHECK(segment_blossom(curve, span, asked) == expected);
            CHECK(blossom_value(segment(curve, span), asked) == expected);
        }
    }
}

TEST_CASE("derivatives are blossom values with vectors, and splines of lower degree", "[de_boor]") {
    Random random(5);
    for (int round = 0; round < 150; ++round) {
        const SplineRecipe recipe = spline(random, random.below(6));
        const BSplineCurve curve = recipe.curve();
        const std::size_t order = random.below(recipe.degree + 2);
        const Rational t = parameter(random, curve.knots());
        const Coordinates expected =
            order > recipe.degree
                ? Coordinates(curve.dimension())
                : derivative_of_oracle(recipe.oracle(), textbook::span_of(recipe.oracle(), t), order, t);
        CHECK(derivative(curve, order, t) == expected);
        const BSplineCurve as_spline = derivative_curve(curve, order);
        CHECK(as_spline.degree() == recipe.degree - std::min(order, recipe.degree));
        CHECK(as_spline.knots().domain() == curve.knots().domain());
        CHECK(evaluate(as_spline, t) == expected);
        if (as_spline.degree() > 0) CHECK(as_spline.knots().convention() == curve.knots().convention());
    }
}

TEST_CASE("hart-bspline-segments: the cubic over 0..7 has the segments [2, 3], [3, 4] and [4, 5]",
          "[de_boor][hart]") {
    const BSplineCurve curve = example();
    CHECK(curve.knots().size() == curve.control_points().size() + curve.degree() - 1);
    std::vector<Interval> segments;
    for (const std::size_t span : curve.knots().spans()) {
        segments.emplace_back(curve.knots()[span], curve.knots()[span + 1]);
        for (const Rational& t : {Rational(1, 3), Rational(5, 7)}) {
            const Rational u = curve.knots()[span] + t;
            CHECK(evaluate(curve, u) == evaluate(segment(curve, span), u));
        }
    }
    CHECK(segments == std::vector<Interval>{{2, 3}, {3, 4}, {4, 5}});
}

TEST_CASE("hart-four-points: a point of a segment moves with d + 1 control points, and with no other",
          "[de_boor][hart]") {
    for (std::size_t degree = 0; degree <= 5; ++degree) {
        std::vector<Rational> knots;
        for (int i = 0; i < 14; ++i) knots.emplace_back(i * i);
        const std::size_t points = knots.size() - degree - 1;
        for (const std::size_t span : KnotVector(degree, knots, points).spans()) {
            const Rational t = (knots[span] * 2 + knots[span + 1]) / 3;
            std::size_t moving = 0;
            for (std::size_t j = 0; j < points; ++j) {
                std::vector<Coordinates> unit(points, Coordinates{0});
                unit[j] = {1};
                const BSplineCurve curve(degree, knots, unit);
                const bool moves = !evaluate(curve, t).front().is_zero();
                CHECK(moves == (curve.knots().first_point(span) <= j &&
                                j <= curve.knots().first_point(span) + degree));
                moving += moves ? 1 : 0;
            }
            CHECK(moving == degree + 1);
        }
    }
}

TEST_CASE("hart-three-at-knot: at a simple knot of a cubic three control points count, by 1/6, 2/3, 1/6",
          "[de_boor][hart]") {
    std::vector<Coordinates> units(6, Coordinates(6));
    for (std::size_t i = 0; i < 6; ++i) units[i][i] = 1;
    const BSplineCurve curve(3, {0, 1, 2, 3, 4, 5, 6, 7}, units);
    CHECK(evaluate(curve, 3) == Coordinates{0, Rational(1, 6), Rational(2, 3), Rational(1, 6), 0, 0});
    for (std::size_t multiplicity = 1; multiplicity <= 4; ++multiplicity) {
        std::vector<Rational> knots{0, 1, 2, 3};
        knots.insert(knots.end(), multiplicity, 5);
        knots.insert(knots.end(), {7, 8, 10, 11});
        const std::size_t points = knots.size() - 4;
        std::size_t counting = 0;
        for (std::size_t j = 0; j < points; ++j) {
            std::vector<Coordinates> unit(points, Coordinates{0});
            unit[j] = {1};
            counting += evaluate(BSplineCurve(3, knots, unit), 5).front().is_zero() ? 0U : 1U;
        }
        CHECK(counting == std::max<std::size_t>(4 - multiplicity, 1));
    }
}

TEST_CASE("hart-extra-knots: d - 1 knots beyond the domain matter at each end, a further one does not",
          "[de_boor][hart]") {
    Random random(6);
    for (std::size_t degree = 1; degree <= 5; ++degree) {
        const std::vector<std::size_t> inner{1, 1};
        const SplineRecipe polar =
            spline(random, degree, inner, KnotConvention::polar, Ends::open, Ends::open);
        CHECK(polar.curve().knots().begin_index() == degree - 1);
        const BSplineCurve curve = polar.curve();
        for (const Rational& distance : {Rational(0), Rational(1), Rational(17, 3)}) {
            std::vector<Rational> knots = polar.knots;
            knots.insert(knots.begin(), polar.knots.front() - distance);
            knots.push_back(polar.knots.back() + distance * 2);
            if (distance.is_zero() && degree == 1) continue;
            const BSplineCurve padded(degree, knots, polar.points);
            for (int step = 0; step <= 12; ++step) {
                const Interval domain = curve.knots().domain();
                const Rational t = domain.a() + (domain.b() - domain.a()) * Rational(step, 12);
                CHECK(evaluate(padded, t) == evaluate(curve, t));
            }
        }
        if (degree < 2) continue;
        std::vector<Rational> moved = polar.knots;
        moved.front() -= 1;
        std::vector<Coordinates> points = polar.points;
        points.front().front() += 1;
        const BSplineCurve one(degree, polar.knots, points);
        const BSplineCurve other(degree, moved, points);
        const Rational middle = (curve.knots()[degree - 1] + curve.knots()[degree]) / 2;
        CHECK_FALSE(evaluate(one, middle) == evaluate(other, middle));
    }
}

TEST_CASE("fj-bspline-same-segment: the inverse formula needs all arguments in one segment",
          "[de_boor][fj]") {
    const BSplineCurve curve = example();
    const auto at = [&](const Rational& t) { return evaluate(curve, t); };
    const std::vector<Parameter> same{Rational(13, 4), Rational(7, 2), Rational(15, 4)};
    CHECK(blossom_from_values(at, same) ==
          segment_blossom(curve, 3, std::vector<Argument>(same.begin(), same.end())));

    const std::vector<Parameter> different{Rational(5, 2), Rational(7, 2), Rational(9, 2)};
    const Coordinates mixed = blossom_from_values(at, different);
    for (const std::size_t span : curve.knots().spans()) {
        CHECK_FALSE(mixed ==
                    segment_blossom(curve, span, std::vector<Argument>(different.begin(), different.end())));
    }
}

TEST_CASE("the numbers of a spline are refused before they grow too large", "[de_boor]") {
    Limits limits;
    limits.digits = 40;
    const BSplineCurve curve = example();
    CHECK_FALSE(failure([&] { evaluate(curve, 3, limits); }));
    const Rational fine(Integer(1) + pow(Integer(3), 60), pow(Integer(3), 60));
    CHECK(failure_code([&] { evaluate(curve, fine + 2, limits); }) == ErrorCode::limit_exceeded);
    limits = {};
    limits.degree = 2;
    CHECK(failure_code([&] { evaluate(curve, 3, limits); }) == ErrorCode::limit_exceeded);
}
