#include <blossom/core/maps/bspline_curve.hpp>
#include "core_test.hpp"

namespace {

KnotVector knots(std::size_t degree, std::vector<Rational> values, std::size_t points) {
    return {degree, std::move(values), points};
}

const std::vector<Rational> zero_to_seven{0, 1, 2, 3, 4, 5, 6, 7};

}  // namespace

TEST_CASE("the number of knots tells the convention", "[knots]") {
    CHECK(knots(3, zero_to_seven, 6).convention() == KnotConvention::polar);
    CHECK(knots(3, zero_to_seven, 4).convention() == KnotConvention::textbook);
    CHECK(knots(0, {0, 1, 2}, 2).convention() == KnotConvention::textbook);

    const auto wrong = failure([] { knots(3, zero_to_seven, 5); });
    REQUIRE(wrong);
    CHECK(wrong->code() == ErrorCode::bad_knots);
    CHECK(wrong->message() == "5 control points of degree 3 need 9 or 7 knots, not 8");
    CHECK(wrong->place() == Part::knots);
    CHECK(failure_code([] { knots(0, {0}, 2); }) == ErrorCode::bad_knots);
}

TEST_CASE("an error in knots names index, value and rule", "[knots]") {
    const auto repeated = failure([] {
        knots(3, {0, Rational(1, 3), Rational(1, 3), Rational(1, 3), Rational(1, 3), Rational(1, 3), 2, 3},
              6);
    });
    REQUIRE(repeated);
    CHECK(repeated->code() == ErrorCode::bad_knots);
    CHECK(repeated->message() == "knot 5 (1/3) has multiplicity 5, more than degree + 1 = 4");
    CHECK(repeated->place() == Part::knots / 5);

    const auto decreasing = failure([] { knots(2, {0, 1, 3, 2, 4}, 4); });
    REQUIRE(decreasing);
    CHECK(decreasing->code() == ErrorCode::bad_knots);
    CHECK(decreasing->message() == "knot 3 (2) is less than knot 2 (3); knots must not decrease");
    CHECK(decreasing->place() == Part::knots / 3);

    CHECK(failure_code([] { knots(2, {0, 1, 1, 2}, 3); }) == ErrorCode::bad_knots);
    CHECK_FALSE(failure([] { knots(2, {0, 1, 2, 2}, 3); }));
    const auto few = failure([] { knots(3, zero_to_seven, 3); });
    REQUIRE(few);
    CHECK(few->code() == ErrorCode::wrong_arity);
    CHECK(few->place() == Part::control_points);
    CHECK(failure_code([] { knots(SIZE_MAX, {0, 1}, 2); }) == ErrorCode::wrong_arity);
    CHECK_FALSE(failure([] { knots(3, {0, 0, 0, 0, 1, 1, 1, 1}, 4); }));
    CHECK(failure_code([] { knots(3, {0, 0, 0, 0, 0, 1, 1, 1, 1}, 5); }) == ErrorCode::bad_knots);
}

TEST_CASE("points must be as many as the knots are for, and of one dimension", "[knots]") {
    const KnotVector linear = knots(1, {0, 0, 1, 1}, 2);
    CHECK(failure_code([&] { BSplineCurve(linear, {{1}, {2}, {3}}); }) == ErrorCode::wrong_arity);
    const auto mixed = failure([&] { BSplineCurve(linear, {{1}, {2, 3}}); });
    REQUIRE(mixed);
    CHECK(mixed->code() == ErrorCode::mismatched_dimensions);
    CHECK(mixed->place() == Part::control_points / 1);
    CHECK(failure_code([&] { BSplineCurve(linear, {{}, {}}); }) == ErrorCode::mismatched_dimensions);
    CHECK(BSplineCurve(linear, {{1}, {2}}) == BSplineCurve(1, {0, 0, 1, 1}, {{1}, {2}}));
    CHECK_FALSE(BSplineCurve(linear, {{1}, {2}}) == BSplineCurve(1, {0, 1}, {{1}, {2}}));
}

TEST_CASE("spans, windows and the domain in both conventions", "[knots]") {
    const KnotVector polar = knots(3, zero_to_seven, 6);
    CHECK(polar.domain() == Interval(2, 5));
    CHECK(polar.spans() == std::vector<std::size_t>{2, 3, 4});
    CHECK(polar.first_point(3) == 1U);
    CHECK(std::ranges::equal(polar.window(1), std::vector<Rational>{1, 2, 3}));
    CHECK(std::ranges::equal(polar.around(3), std::vector<Rational>{1, 2, 3, 4, 5, 6}));

    const KnotVector textbook = knots(3, {-1, 0, 1, 2, 3, 4, 5, 6, 7, 8}, 6);
    CHECK(textbook.domain() == Interval(2, 5));
    CHECK(textbook.spans() == std::vector<std::size_t>{3, 4, 5});
    CHECK(textbook.first_point(4) == 1U);
    CHECK(std::ranges::equal(textbook.window(1), std::vector<Rational>{1, 2, 3}));
    CHECK(std::ranges::equal(textbook.around(4), std::vector<Rational>{1, 2, 3, 4, 5, 6}));

    const KnotVector repeated = knots(2, {0, 0, 0, 1, 1, 1, 3, 3, 3}, 6);
    CHECK(repeated.spans() == std::vector<std::size_t>{2, 5});
    CHECK(repeated.distinct() == std::vector<KnotMultiplicity>{{0, 3}, {1, 3}, {3, 3}});
    CHECK(repeated.multiplicity(1) == 3U);
    CHECK(repeated.multiplicity(2) == 0U);
}

TEST_CASE("the span of a parameter lies to its right, at the end of the domain it is the last", "[knots]") {
    const KnotVector repeated = knots(2, {0, 0, 0, 1, 1, 1, 3, 3, 3}, 6);
    CHECK(repeated.span_at(0) == 2U);
    CHECK(repeated.span_at(1) == 5U);
    CHECK(repeated.span_at(3) == 5U);
    CHECK(repeated.span_before(1) == 2U);
    CHECK(repeated.span_before(0) == 2U);
    CHECK(repeated.span_before(3) == 5U);
    const KnotVector long_ends = knots(1, {0, 1, 1, 2, 2, 3}, 4);
    CHECK(long_ends.domain() == Interval(1, 2));
    CHECK(long_ends.span_at(1) == 2U);
    CHECK(long_ends.span_at(2) == 2U);

    const auto outside = failure([] { (void)knots(3, zero_to_seven, 6).span_at(Rational(11, 2)); });
    REQUIRE(outside);
    CHECK(outside->code() == ErrorCode::outside_domain);
    CHECK(outside->message() == "the parameter 11/2 lies outside the domain [2, 5]");
    CHECK(failure_code([] { (void)knots(3, zero_to_seven, 6).span_at(1); }) == ErrorCode::outside_domain);

    Random random(1);
    for (int round = 0; round < 300; ++round) {
        const SplineRecipe recipe = spline(random, random.below(7));
        const textbook::Spline plain = recipe.oracle();
        const KnotVector of_curve = recipe.curve().knots();
        const std::size_t shift = plain.knots.size() == recipe.knots.size() ? 0 : 1;
        const Rational t = parameter(random, of_curve);
        CHECK(of_curve.span_at(t) + shift == textbook::span_of(plain, t));
    }
}

TEST_CASE("only spans of the domain that are not empty are segments", "[knots]") {
    const KnotVector repeated = knots(2, {0, 0, 0, 1, 1, 1, 3, 3, 3}, 6);
    CHECK_FALSE(failure([&] { repeated.require_span(2); }));
    for (const std::size_t span : {0U, 1U, 3U, 4U, 6U, 7U, 100U}) {
        const auto refused = failure([&] { repeated.require_span(span); });
        REQUIRE(refused);
        CHECK(refused->code() == ErrorCode::outside_domain);
        CHECK(refused->place() == Part::segment);
    }
}

TEST_CASE("the spline generator makes what it claims", "[knots][generators]") {
    Random random(2);
    std::size_t textbook_count = 0;
    std::size_t polar_count = 0;
    std::size_t jumps = 0;
    std::size_t clamped = 0;
    std::size_t open = 0;
    std::vector<std::size_t> by_spans(9);
    for (int round = 0; round < 2000; ++round) {
        const std::size_t degree = random.below(7);
        const SplineRecipe recipe = spline(random, degree);
        const KnotVector of_curve = recipe.curve().knots();
        ++(of_curve.convention() == KnotConvention::textbook ? textbook_count : polar_count);
        ++by_spans.at(of_curve.spans().size());
        const Interval domain = of_curve.domain();
        for (const auto& [knot, multiplicity] : of_curve.distinct()) {
            if (domain.a() < knot && knot < domain.b()) jumps += multiplicity == degree + 1 ? 1 : 0;
        }
        (of_curve.knots().front() == domain.a() ? clamped : open) += 1;
        CHECK((of_curve.begin_index() + 1 == of_curve.end_index() ||
               domain.a() < of_curve[of_curve.begin_index() + 1]));
    }
    CHECK(textbook_count > 500);
    CHECK(polar_count > 500);
    CHECK(jumps > 300);
    CHECK(clamped > 400);
    CHECK(open > 400);
    for (std::size_t spans = 1; spans <= 8; ++spans) CHECK(by_spans[spans] > 100);

    std::size_t patterns = 0;
    for_each_pattern(3, 4, [&](std::span<const std::size_t>) { ++patterns; });
    CHECK(patterns == 1U + 4U + 16U + 64U);
}
