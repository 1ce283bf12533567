#include <blossom/core/maps/hermite_curve.hpp>
#include "core_test.hpp"

namespace {

/// P^(k)(x) from the coefficients: sum_i c_i i (i - 1) ... (i - k + 1) x^(i - k).
Coordinates derived(const std::vector<Coordinates>& coefficients, std::size_t k, const Rational& x) {
    Coordinates sum(coefficients.front().size());
    for (std::size_t i = k; i < coefficients.size(); ++i) {
        Rational factor = 1;
        for (std::size_t j = 0; j < k; ++j) factor *= Rational(i - j);
        for (std::size_t j = k; j < i; ++j) factor *= x;
        for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += factor * coefficients[i][c];
    }
    return sum;
}

std::vector<Coordinates> derivatives(const PolynomialRecipe& recipe, std::size_t count, const Rational& x) {
    std::vector<Coordinates> all;
    for (std::size_t k = 0; k < count; ++k) all.push_back(derived(recipe.coefficients, k, x));
    return all;
}

}  // namespace

TEST_CASE("the control points of cubic and quintic Hermite data are those of the textbook", "[hermite]") {
    Random random(331);
    for (std::size_t i = 0; i < 60; ++i) {
        const Interval over = interval(random, Size::small);
        const Rational h = over.b() - over.a();
        const Rational p0 = number(random, Size::small), v0 = number(random, Size::small),
                       s0 = number(random, Size::small), p1 = number(random, Size::small),
                       v1 = number(random, Size::small), s1 = number(random, Size::small);
        CAPTURE(i, over.a(), over.b(), p0, v0, s0, p1, v1, s1);
        const HermiteCurve cubic(std::vector<Coordinates>{{p0}, {v0}}, std::vector<Coordinates>{{p1}, {v1}},
                                 over);
        CHECK(bezier_form(cubic) ==
              BezierCurve(std::vector<Coordinates>{{p0}, {p0 + h * v0 / 3}, {p1 - h * v1 / 3}, {p1}}, over));
        const HermiteCurve quintic(std::vector<Coordinates>{{p0}, {v0}, {s0}},
                                   std::vector<Coordinates>{{p1}, {v1}, {s1}}, over);
        CHECK(bezier_form(quintic) ==
              BezierCurve(std::vector<Coordinates>{{p0},
                                                   {p0 + h * v0 / 5},
                                                   {p0 + 2 * h * v0 / 5 + h * h * s0 / 20},
                                                   {p1 - 2 * h * v1 / 5 + h * h * s1 / 20},
                                                   {p1 - h * v1 / 5},
                                                   {p1}},
                          over));
    }
}

TEST_CASE("a polynomial is determined by its derivatives at two ends", "[hermite]") {
    Random random(332);
    for (std::size_t n = 0; n <= 8; ++n) {
        for (std::size_t left = 0; left <= n + 1; ++left) {
            for (const Size size : {Size::small, Size::any}) {
                const PolynomialRecipe recipe = polynomial_map(random, n, size);
                const Interval over = interval(random, size);
                CAPTURE(n, left, over.a(), over.b(), recipe.curve());
                const auto at_left = derivatives(recipe, left, over.a());
                const auto at_right = derivatives(recipe, n + 1 - left, over.b());
                const HermiteCurve curve(at_left, at_right, over);
                CHECK(curve.degree() == n);
                CHECK(curve.dimension() == recipe.dimension());
                CHECK(curve.left_count() == left);
                CHECK(curve.right_count() == n + 1 - left);
                const BezierCurve bezier = bezier_form(curve);
                CHECK(expanded(bezier) == expanded(recipe.curve()));
                CHECK(bezier.interval() == over);
                CHECK(hermite_form(bezier, left) == curve);
                CHECK(hermite_form(control_points(recipe.curve(), over), left) == curve);
            }
        }
    }
}

TEST_CASE("derivatives at an end are blossom values with delta", "[hermite]") {
    const BezierCurve curve(std::vector<Coordinates>{{1, 0}, {2, 5}, {-3, 1}, {4, 4}, {0, 7}},
                            Interval(2, -1));
    const Blossom blossom(curve);
    const std::vector<Coordinates> found = hermite_form(curve, 3).derivatives().to_points();
    Rational factor = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        Coordinates expected = blossom(with_copies(with_copies({}, 4 - k, Parameter(2)), k, delta));
        for (Rational& coordinate : expected) coordinate *= factor;
        CHECK(found[k] == expected);
        factor *= Rational(4 - k);
    }
}

TEST_CASE("Hermite data that determine no curve are refused", "[hermite]") {
    const std::vector<Coordinates> none, one{{1}}, mixed{{1}, {2, 3}};
    CHECK(failure_code([&] { HermiteCurve(none, none); }) == ErrorCode::wrong_arity);
    const auto at_left = failure([&] { HermiteCurve(mixed, one); });
    REQUIRE(at_left);
    CHECK(at_left->code() == ErrorCode::mismatched_dimensions);
    CHECK(at_left->place() == Part::left / 1);
    CHECK(failure([&] { HermiteCurve(one, mixed); })->place() == Part::right / 1);
    const BezierCurve line(std::vector<Coordinates>{{0}, {1}}, Interval());
    CHECK(failure_code([&] { hermite_form(line, 3); }) == ErrorCode::wrong_arity);
}

TEST_CASE("Hermite data with too large results are refused", "[hermite][limits]") {
    Limits limits;
    limits.digits = 60;
    const std::vector<Coordinates> three{{1}, {2}, {3}};
    const HermiteCurve small(three, three);
    CHECK(bezier_form(small, limits).degree() == 5);
    const HermiteCurve wide(three, three, Interval(0, pow(Rational(2), 100)));
    CHECK(failure_code([&] { bezier_form(wide, limits); }) == ErrorCode::limit_exceeded);
    CHECK(failure_code([&] { hermite_form(bezier_form(wide), 3, limits); }) == ErrorCode::limit_exceeded);
}
