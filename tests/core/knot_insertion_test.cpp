#include "core_test.hpp"

TEST_CASE("the examples of insertion, by Boehm and by Oslo", "[insertion]") {
    const BSplineCurve one = insert_knots_boehm(example_spline(), std::vector<Rational>{Rational(7, 2)});
    CHECK(one == BSplineCurve(3, {0, 1, 2, 3, Rational(7, 2), 4, 5, 6, 7},
                              {{0, 0},
                               {1, 2},
                               {Rational(8, 3), Rational(17, 6)},
                               {4, 2},
                               {Rational(31, 6), Rational(5, 6)},
                               {6, 0},
                               {8, 2}}));
    const BSplineCurve textbook(3, {-1, 0, 1, 2, 3, 4, 5, 6, 7, 8}, example_spline().control_points());
    const std::vector<Rational> three{Rational(7, 2), Rational(7, 2), Rational(5, 2)};
    const BSplineCurve refined(
        3, {-1, 0, 1, 2, Rational(5, 2), 3, Rational(7, 2), Rational(7, 2), 4, 5, 6, 7, 8},
        {{0, 0},
         {Rational(5, 6), Rational(5, 3)},
         {2, Rational(5, 2)},
         {3, Rational(21, 8)},
         {Rational(11, 3), Rational(53, 24)},
         {Rational(103, 24), Rational(41, 24)},
         {Rational(31, 6), Rational(5, 6)},
         {6, 0},
         {8, 2}});
    CHECK(insert_knots_oslo(textbook, three) == refined);
    CHECK(insert_knots_boehm(textbook, three) == refined);
}

TEST_CASE("derose-boehm-new: v^_j = ((t_(j+d-1) - t^) v_(j-1) + (t^ - t_(j-1)) v_j) / (t_(j+d-1) - t_(j-1))",
          "[insertion][derose]") {
    Random random(21);
    for (int round = 0; round < 200; ++round) {
        const std::size_t d = 1 + random.below(6);
        const std::vector<std::size_t> inner(random.below(6), 1);
        const SplineRecipe recipe = spline(random, d, inner, KnotConvention::polar, Ends::open, Ends::open);
        const BSplineCurve curve = recipe.curve();
        const auto spans = curve.knots().spans();
        const std::size_t span = spans[random.below(spans.size())];
        const auto& t = recipe.knots;
        const Rational inserted = t[span] + (t[span + 1] - t[span]) * Rational(random.between(1, 9), 10);
        const BSplineCurve refined = insert_knots_boehm(curve, std::vector<Rational>{inserted});
        std::vector<Coordinates> expected(recipe.points.begin(),
                                          recipe.points.begin() + static_cast<std::ptrdiff_t>(span + 2 - d));
        for (std::size_t j = span + 2 - d; j <= span + 1; ++j) {
            Coordinates& point = expected.emplace_back();
            for (std::size_t i = 0; i < curve.dimension(); ++i) {
                point.push_back(((t[j + d - 1] - inserted) * recipe.points[j - 1][i] +
                                 (inserted - t[j - 1]) * recipe.points[j][i]) /
                                (t[j + d - 1] - t[j - 1]));
            }
        }
        expected.insert(expected.end(), recipe.points.begin() + static_cast<std::ptrdiff_t>(span + 1),
                        recipe.points.end());
        CHECK(refined.control_points() == expected);
    }
}

TEST_CASE(
    "derose-boehm-repeat, derose-oslo: knot by knot in any order, all at once, and Oslo give one answer, the "
    "same map",
    "[insertion][derose]") {
    Random random(22);
    for (int round = 0; round < 300; ++round) {
        const SplineRecipe recipe =
            spline(random, random.below(7), random.one_in(6) ? Size::any : Size::small);
        const BSplineCurve curve = recipe.curve();
        const std::vector<Rational> knots = insertable(random, curve.knots(), 8);
        const BSplineCurve boehm = insert_knots_boehm(curve, knots);
        CHECK(boehm == insert_knots_oslo(curve, knots));
        BSplineCurve one_by_one = curve;
        for (const Rational& knot : knots)
            one_by_one = insert_knots_boehm(one_by_one, std::vector<Rational>{knot});
        CHECK(boehm == one_by_one);
        CHECK(boehm.knots().convention() == curve.knots().convention());
        if (recipe.degree <= 4) CHECK(textbook::same_map(oracle(boehm), recipe.oracle()));
        std::vector<Rational> expected = recipe.knots;
        expected.insert(expected.end(), knots.begin(), knots.end());
        std::ranges::sort(expected);
        CHECK(boehm.knots().knots() == expected);
    }
}

TEST_CASE(
    "derose-oslo: every new control point is the blossom value at its window, of every segment that it "
    "influences",
    "[insertion][derose]") {
    Random random(23);
    for (int round = 0; round < 150; ++round) {
        const SplineRecipe recipe = spline(random, random.below(5));
        const BSplineCurve curve = recipe.curve();
        const textbook::Spline plain = recipe.oracle();
        const BSplineCurve refined = insert_knots_oslo(curve, insertable(random, curve.knots(), 6));
        const textbook::Spline finer = oracle(refined);
        for (std::size_t j = 0; j < finer.points.size(); ++j) {
            std::vector<Argument> window;
            for (std::size_t i = 0; i < recipe.degree; ++i)
                window.emplace_back(Parameter(finer.knots[j + 1 + i]));
            for (std::size_t span = recipe.degree; span < plain.points.size(); ++span) {
                const Rational& begin = std::max(plain.knots[span], finer.knots[j]);
                const Rational& end = std::min(plain.knots[span + 1], finer.knots[j + recipe.degree + 1]);
                if (begin < end) CHECK(finer.points[j] == textbook::segment_blossom(plain, span, window));
            }
        }
    }
}

TEST_CASE(
    "knots are inserted at the ends of the domain up to degree + 1 times, points without influence are kept",
    "[insertion]") {
    Random random(24);
    for (int round = 0; round < 150; ++round) {
        const SplineRecipe recipe = spline(random, random.below(6));
        const BSplineCurve curve = recipe.curve();
        const Interval domain = curve.knots().domain();
        std::vector<Rational> ends;
        for (const Rational& end : {domain.a(), domain.b()}) {
            ends.insert(ends.end(),
                        recipe.degree + 1 - std::min(recipe.degree + 1, curve.knots().multiplicity(end)),
                        end);
        }
        const BSplineCurve full = insert_knots_boehm(curve, ends);
        CHECK(full == insert_knots_oslo(curve, ends));
        CHECK(full.knots().domain() == domain);
        CHECK(textbook::same_map(oracle(full), recipe.oracle()));

        std::vector<Coordinates> marked = full.control_points();
        marked.front().front() += 1000;
        marked.back().front() += 2000;
        const BSplineCurve other(full.knots(), marked);
        const std::vector<Rational> more = insertable(random, full.knots(), 4);
        const BSplineCurve refined = insert_knots_boehm(other, more);
        CHECK(refined == insert_knots_oslo(other, more));
        CHECK(textbook::same_map(oracle(refined), oracle(other)));
    }
}

TEST_CASE("what cannot be inserted is refused by index and rule", "[insertion]") {
    for (const auto insert : {insert_knots_boehm, insert_knots_oslo}) {
        const auto outside =
            failure([&] { insert(example_spline(), std::vector<Rational>{3, Rational(11, 2)}, {}); });
        REQUIRE(outside);
        CHECK(outside->code() == ErrorCode::outside_domain);
        CHECK(outside->message() == "knot 1 to insert (11/2) lies outside the domain [2, 5]");
        CHECK(outside->place() == Part::knots / 1);
        const auto repeated =
            failure([&] { insert(example_spline(), std::vector<Rational>{3, 4, 3, 3, 3}, {}); });
        REQUIRE(repeated);
        CHECK(repeated->code() == ErrorCode::bad_knots);
        CHECK(repeated->message() ==
              "knot 4 to insert (3) would have multiplicity 5, more than degree + 1 = 4");
        CHECK(repeated->place() == Part::knots / 4);
        CHECK(failure_code([&] { insert(BSplineCurve(0, {0, 1}, {{1}}), std::vector<Rational>{0}, {}); }) ==
              ErrorCode::bad_knots);
        Limits limits;
        limits.numbers = 13;
        CHECK(failure_code([&] { insert(example_spline(), std::vector<Rational>{3}, limits); }) ==
              ErrorCode::limit_exceeded);
        limits.numbers = 14;
        CHECK_FALSE(failure([&] { insert(example_spline(), std::vector<Rational>{3}, limits); }));
        CHECK(insert(example_spline(), std::vector<Rational>{}, {}) == example_spline());
    }
    const BSplineCurve steps(0, {0, 1, 2}, {{5}, {7}});
    CHECK(insert_knots_boehm(steps, std::vector<Rational>{Rational(1, 2)}) ==
          BSplineCurve(0, {0, Rational(1, 2), 1, 2}, {{5}, {5}, {7}}));
}
