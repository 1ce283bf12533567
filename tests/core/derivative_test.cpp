#include "core_test.hpp"

namespace {

Coordinates value(const PolynomialMap& map, const Parameter& t) {
    return std::visit([&](const auto& curve) { return evaluate(curve, t); }, map);
}

std::size_t degree(const PolynomialMap& map) {
    return std::visit([](const auto& curve) { return curve.degree(); }, map);
}

}  // namespace

TEST_CASE("derivatives of polynomial maps against those of their powers", "[derivative]") {
    Random random(241);
    for (int i = 0; i < 800; ++i) {
        const std::size_t n = random.below(7);
        const PolynomialRecipe recipe = polynomial_map(random, n, Size::any);
        const PolynomialMap map = recipe.curve();
        const Parameter t = point(random, Size::small);
        for (std::size_t order = 0; order <= n + 2; ++order) {
            CAPTURE(n, order, t.value);
            const auto expected = textbook::polynomial_value(recipe.coefficients, t.value, order);
            CHECK(textbook::text(derivative(map, order, t)) == expected);
            const PolynomialMap derived = derivative_map(map, order);
            CHECK(degree(derived) == (order > n ? 0 : n - order));
            CHECK(std::holds_alternative<PolynomialCurve>(derived));
            CHECK(textbook::text(value(derived, t)) == expected);
        }
    }
}

TEST_CASE("derivatives of control polygons are those of the same polynomial", "[derivative]") {
    Random random(242);
    for (int i = 0; i < 800; ++i) {
        const std::size_t n = random.below(7);
        const BezierRecipe recipe = bezier_map(random, n, Size::small);
        const PolynomialMap map = recipe.curve();
        const PolynomialMap monomial = monomial_form(recipe.curve());
        const Parameter t = point(random, Size::small);
        for (std::size_t order = 0; order <= n + 2; ++order) {
            CAPTURE(n, order, t.value, recipe.interval.a(), recipe.interval.b());
            const Coordinates expected = value(derivative_map(monomial, order), t);
            CHECK(derivative(map, order, t) == expected);
            const PolynomialMap derived = derivative_map(map, order);
            CHECK(degree(derived) == (order > n ? 0 : n - order));
            REQUIRE(std::holds_alternative<BezierCurve>(derived));
            CHECK(std::get<BezierCurve>(derived).interval() == recipe.interval);
            CHECK(value(derived, t) == expected);
        }
    }
}

TEST_CASE("derivatives of derivatives add their orders", "[derivative]") {
    Random random(243);
    for (int i = 0; i < 300; ++i) {
        const std::size_t n = random.below(7);
        const PolynomialMap map = any_map(random, n, Size::any);
        const std::size_t first = random.below(n + 2);
        const std::size_t second = random.below(n + 2);
        CAPTURE(n, first, second);
        CHECK(derivative_map(derivative_map(map, first), second) == derivative_map(map, first + second));
        CHECK(derivative_map(map, 0) == map);
    }
}
