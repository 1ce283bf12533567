#include <blossom/core/spline/knot_removal.hpp>
#include <blossom/core/spline/spline_elevation.hpp>
#include <blossom/core/spline/spline_join.hpp>
#include <blossom/core/spline/spline_split.hpp>
#include "core_test.hpp"

// Every pattern of multiplicities, through every change of representation and back.

namespace {

BSplineCurve without(BSplineCurve curve, const std::vector<Rational>& knots) {
    for (const Rational& knot : knots) {
        const KnotRemoval removal = remove_knot(curve, knot);
        if (removal.removed != 1) return curve;
        curve = removal.curve;
    }
    return curve;
}

/// The segments of the raised spline, lowered again by the control points of their monomial forms.
BSplineCurve raised_and_lowered(const BSplineCurve& curve, std::size_t r) {
    std::vector<BezierCurve> segments = bezier_segments(elevate(curve, r));
    for (BezierCurve& segment : segments) {
        const PolynomialCurve same(monomial_form(segment).coefficients().to_points(), curve.degree());
        segment = control_points(same, segment.interval());
    }
    return join(segments, curve.knots());
}

void check_round_trips(Random& random, const SplineRecipe& recipe) {
    const BSplineCurve curve = recipe.curve();
    const std::vector<Rational> knots = insertable(random, curve.knots(), 5);
    const BSplineCurve boehm = insert_knots_boehm(curve, knots);
    CHECK(boehm == insert_knots_oslo(curve, knots));
    CHECK(without(boehm, knots) == curve);
    CHECK(join(bezier_segments(curve), curve.knots()) == curve);
    CHECK(raised_and_lowered(curve, 1 + random.below(2)) == curve);
    const Rational t = parameter(random, curve.knots());
    const Coordinates value = textbook::value(recipe.oracle(), t);
    CHECK(evaluate(curve, t) == value);
    CHECK(evaluate(boehm, t) == value);
}

/// A cubic with unrelated denominators.
BSplineCurve large_curve(Random& random, std::size_t points) {
    std::vector<Rational> knots;
    std::vector<Coordinates> control_points;
    Rational knot;
    for (std::size_t i = 0; i < points + 4; ++i)
        knots.push_back(knot += Rational(random.between(1, 99), 100));
    for (std::size_t i = 0; i < points; ++i) {
        control_points.push_back(
            {Rational(random.between(-1000, 1000), random.between(1, 1'000'000)), small_rational(random)});
    }
    return {3, std::move(knots), std::move(control_points)};
}

}  // namespace

TEST_CASE("insert, refine, extract, join, elevate and remove come back for every pattern of multiplicities",
          "[round_trips]") {
    Random random(81);
    const std::size_t most_joints[] = {7, 7, 5, 4, 3, 3, 3};
    for (std::size_t degree = 0; degree <= 6; ++degree) {
        for_each_pattern(most_joints[degree], degree + 1, [&](std::span<const std::size_t> pattern) {
            const bool polar = degree > 0 && random.one_in(2);
            const auto begin = static_cast<Ends>(random.below(3));
            const auto end = static_cast<Ends>(random.below(3));
            check_round_trips(random,
                              spline(random, degree, pattern,
                                     polar ? KnotConvention::polar : KnotConvention::textbook, begin, end));
        });
    }
}

TEST_CASE("and for random ones on up to 8 spans, with numbers of every size", "[round_trips]") {
    Random random(82);
    for (int round = 0; round < 350; ++round) {
        check_round_trips(random, spline(random, static_cast<std::size_t>(round) % 7,
                                         random.one_in(7) ? Size::any : Size::small));
    }
}

TEST_CASE("ten thousand control points are refined, extracted and evaluated in linear memory",
          "[round_trips]") {
    Random random(83);
    const std::size_t before = peak_memory();
    const BSplineCurve curve = large_curve(random, 10'000);
    std::vector<Rational> knots;
    for (const std::size_t span : curve.knots().spans())
        knots.push_back((curve.knots()[span] + curve.knots()[span + 1]) / 2);
    knots.resize(10'000, curve.knots().domain().b());
    const BSplineCurve refined = insert_knots_boehm(curve, std::span(knots).first(9'997));
    CHECK(refined == insert_knots_oslo(curve, std::span(knots).first(9'997)));
    CHECK(bezier_segments(curve).size() == 9'997);
    for (std::size_t i = 0; i < 10'000; ++i) {
        const Rational& t = knots[i * 7 % 9'997];
        if (i % 10 == 0) CHECK(evaluate(refined, t) == evaluate(curve, t));
    }
    CHECK(peak_memory() - before < 200);
}
