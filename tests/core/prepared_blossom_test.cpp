#include <thread>
#include "core_test.hpp"

// A prepared blossom gives the same values by every function, for all sizes of numbers.

namespace {

Size any_size(Random& random) { return random.one_in(3) ? Size::any : Size::small; }

/// Compares all values of one batch with single values, and these with the definition.
template <class Recipe, class Oracle>
void check(Random& random, const Recipe& recipe, const Oracle& oracle) {
    const Blossom blossom(recipe.curve());
    std::vector<std::vector<Argument>> tuples;
    for (std::size_t i = random.below(20); i > 0; --i)
        tuples.push_back(arguments(random, blossom.degree(), any_size(random)));
    const std::size_t jobs = 1 + random.below(3);
    const std::vector<Rational> values = blossom.values(tuples, jobs);
    REQUIRE(values.size() == tuples.size() * blossom.dimension());
    // Memory of the caller that already holds numbers of any size.
    std::vector<Rational> results(values.size());
    if (random.one_in(2))
        for (Rational& result : results) result = rational(random);
    blossom.values(tuples, results, jobs);
    CHECK(results == values);
    for (std::size_t i = 0; i < tuples.size(); ++i) {
        const Coordinates expected(
            values.begin() + static_cast<std::ptrdiff_t>(i * blossom.dimension()),
            values.begin() + static_cast<std::ptrdiff_t>((i + 1) * blossom.dimension()));
        CAPTURE(i, jobs, tuples[i]);
        CHECK(blossom(tuples[i]) == expected);
        // The first values are computed without the prepared form.
        const Blossom fresh(recipe.curve());
        CHECK(fresh(tuples[i]) == expected);
        CHECK(fresh.values({&tuples[i], 1}) == expected);
        for (std::size_t j = 0; j < blossom.dimension(); ++j)
            CHECK(Blossom(recipe.curve()).coordinate(j, tuples[i]) == expected[j]);
        for (std::size_t j = 0; j < blossom.dimension(); ++j)
            CHECK(blossom.coordinate(j, tuples[i]) == expected[j]);
        if (i == 0) CHECK(textbook::text(expected) == oracle(tuples[i]));
    }
}

}  // namespace

TEST_CASE("prepared blossoms of polynomials, one by one and in batches", "[blossom][batch]") {
    Random random(311);
    for (int i = 0; i < 1000; ++i) {
        const PolynomialRecipe recipe = polynomial_map(random, random.below(8), any_size(random));
        check(random, recipe,
              [&](const auto& list) { return textbook::blossom_of_coefficients(recipe.coefficients, list); });
    }
}

TEST_CASE("prepared blossoms of control polygons, one by one and in batches", "[blossom][batch]") {
    Random random(312);
    for (int i = 0; i < 1000; ++i) {
        const BezierRecipe recipe = bezier_map(random, random.below(8), any_size(random));
        check(random, recipe, [&](const auto& list) {
            return textbook::blossom_of_control_points(recipe.control_points, recipe.interval, list);
        });
    }
}

TEST_CASE("arguments at the limits of a word over every interval", "[blossom]") {
    const Integer most = INT64_MAX;
    const Integer least = INT64_MIN;
    const std::vector<Argument> extremes{Parameter(Rational(most)),    Parameter(Rational(least)),
                                         Parameter(Rational(1, most)), Parameter(Rational(1, most + 1)),
                                         Direction{Rational(least)},   Argument(most, most)};
    const std::vector<Coordinates> points{{3}, {Rational(1, 5)}, {-7}};
    for (const Interval& interval :
         {Interval(), Interval(1, 0), Interval(most, least), Interval(Rational(1, most), Rational(-2, most)),
          Interval(most, most + 1), Interval(0, most + 1)}) {
        const Blossom blossom(BezierCurve(points, interval));
        for (const Argument& first : extremes) {
            for (const Argument& second : extremes) {
                const std::vector<Argument> list{first, second};
                CAPTURE(interval.a(), interval.b(), list);
                CHECK(textbook::text(blossom(list)) ==
                      textbook::blossom_of_control_points(points, interval, list));
            }
        }
    }
}

TEST_CASE("batches refuse what single values refuse", "[blossom][batch]") {
    const Blossom blossom(PolynomialCurve(Polynomial::monomial(2)), Limits{.digits = 40});
    std::vector<std::vector<Argument>> tuples(40, {Parameter(1), Parameter(2)});
    CHECK(blossom.values(tuples, 2) == std::vector<Rational>(40, 2));
    CHECK(blossom.values({}, 2).empty());
    tuples[30][0] = Parameter(pow(Integer(10), 60));
    CHECK(failure_code([&] { blossom.values(tuples, 2); }) == ErrorCode::limit_exceeded);
    tuples[30].pop_back();
    CHECK(failure_code([&] { blossom.values(tuples, 2); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([&] { blossom.coordinate(0, tuples[30]); }) == ErrorCode::wrong_arity);
}

TEST_CASE("batches fill exactly the places they are given", "[blossom][batch]") {
    const Blossom blossom(
        PolynomialCurve(std::vector<Coordinates>{{1, 2}, {0, Rational(1, 3)}, {Rational(5, 7), -1}}));
    std::vector<std::vector<Argument>> tuples(11, {Parameter(Rational(1, 2)), Parameter(3)});
    const std::vector<Rational> untouched(24, Rational(pow(Integer(10), 40)));
    std::vector<Rational> results = untouched;
    blossom.values(tuples, std::span(results).first(22));
    const Coordinates expected = blossom(tuples[0]);
    for (std::size_t i = 0; i < 22; ++i) CHECK(results[i] == expected[i % 2]);
    CHECK(results[22] == untouched[22]);
    CHECK(results[23] == untouched[23]);

    results = untouched;
    for (const std::size_t size : {0U, 11U, 21U, 23U, 24U}) {
        const std::optional<Error> error =
            failure([&] { blossom.values(tuples, std::span(results).first(size), 2); });
        REQUIRE(error);
        CHECK(error->code() == ErrorCode::mismatched_dimensions);
        CHECK(error->place() == Part::results);
    }
    tuples[10].pop_back();
    CHECK(failure_code([&] { blossom.values(tuples, std::span(results).first(22)); }) ==
          ErrorCode::wrong_arity);
    CHECK(results == untouched);
    blossom.values({}, std::span<Rational>());
}

TEST_CASE("several threads use a new blossom at the same time") {
    Random random(313);
    for (int i = 0; i < 200; ++i) {
        const PolynomialRecipe recipe = polynomial_map(random, random.below(8), any_size(random));
        const std::vector<Argument> tuple = arguments(random, recipe.curve().degree(), any_size(random));
        const Coordinates expected = Blossom(recipe.curve())(tuple);
        const Blossom shared(recipe.curve());
        std::array<std::vector<Coordinates>, 3> found;
        {
            std::vector<std::jthread> threads;
            for (auto& values : found) {
                threads.emplace_back([&] {
                    const Blossom copy = shared;
                    for (int k = 0; k < 3; ++k) values.push_back(copy(tuple));
                });
            }
        }
        for (const auto& values : found) CHECK(values == std::vector<Coordinates>(3, expected));
    }
}
