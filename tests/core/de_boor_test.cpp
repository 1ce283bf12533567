#include "core_test.hpp"

namespace {

std::size_t textbook_span(const BSplineCurve& curve, std::size_t span) {
    return span + (curve.knots().convention() == KnotConvention::textbook ? 0 : 1);
}

/// The k-th derivative of the polynomial that the oracle gives for a span.
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
    const BSplineCurve curve = example_spline();
    CHECK(evaluate(curve, 2) == Coordinates{Rational(7, 6), Rational(11, 6)});
    CHECK(evaluate(curve, Rational(7, 2)) == Coordinates{Rational(191, 48), Rational(47, 24)});
    CHECK(evaluate(curve, 5) == Coordinates{Rational(37, 6), Rational(1, 2)});
    CHECK(failure_code([&] { evaluate(curve, Rational(11, 2)); }) == ErrorCode::outside_domain);
    CHECK(failure_code([&] { derivative(curve, 1, 1); }) == ErrorCode::outside_domain);
}

TEST_CASE("the blossom of a segment is selected by its span", "[de_boor]") {
    const BSplineCurve curve = example_spline();
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
    const BSplineCurve curve = example_spline();
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
    const BSplineCurve curve = example_spline();
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
    const BSplineCurve curve = example_spline();
    CHECK_FALSE(failure([&] { evaluate(curve, 3, limits); }));
    const Rational fine(Integer(1) + pow(Integer(3), 60), pow(Integer(3), 60));
    CHECK(failure_code([&] { evaluate(curve, fine + 2, limits); }) == ErrorCode::limit_exceeded);
    limits = {};
    limits.degree = 2;
    CHECK(failure_code([&] { evaluate(curve, 3, limits); }) == ErrorCode::limit_exceeded);
}
