#include "core_test.hpp"

TEST_CASE("values of polynomial maps and control polygons", "[evaluation]") {
    Random random(251);
    for (int i = 0; i < 1500; ++i) {
        const std::size_t n = random.below(9);
        const Size size = random.one_in(2) ? Size::any : Size::small;
        const PolynomialRecipe recipe = polynomial_map(random, n, size);
        const BezierRecipe polygon = bezier_map(random, n, size);
        const Parameter t = point(random, Size::any);
        CAPTURE(n, t.value);
        CHECK(textbook::text(evaluate(recipe.curve(), t)) ==
              textbook::polynomial_value(recipe.coefficients, t.value));
        CHECK(textbook::text(evaluate(polygon.curve(), t)) ==
              textbook::bernstein_value(polygon.control_points, polygon.interval, t.value));
    }
}

TEST_CASE("the control points of a polynomial are blossom values at the ends", "[conversion]") {
    Random random(252);
    for (int i = 0; i < 500; ++i) {
        const std::size_t n = random.below(7);
        const PolynomialRecipe recipe = polynomial_map(random, n, Size::any);
        const Interval chosen = interval(random, random.one_in(3) ? Size::any : Size::small);
        const BezierCurve curve = control_points(recipe.curve(), chosen);
        CHECK(curve.degree() == n);
        CHECK(curve.interval() == chosen);
        for (std::size_t k = 0; k <= n; ++k) {
            const auto ends =
                with_copies(with_copies({}, n - k, Parameter(chosen.a())), k, Parameter(chosen.b()));
            CAPTURE(n, k, chosen.a(), chosen.b());
            CHECK(textbook::text(curve.control_points()[k]) ==
                  textbook::blossom_of_coefficients(recipe.coefficients, ends));
        }
        CHECK(monomial_form(curve) == recipe.curve());
    }
}

TEST_CASE("a control polygon over another interval is the same polynomial", "[conversion]") {
    Random random(253);
    for (int i = 0; i < 400; ++i) {
        const std::size_t n = random.below(7);
        const BezierRecipe recipe = bezier_map(random, n, random.one_in(3) ? Size::any : Size::small);
        const Interval chosen = interval(random, Size::small);
        const BezierCurve curve = control_points(recipe.curve(), chosen);
        const Parameter t = point(random, Size::small);
        CAPTURE(n, chosen.a(), chosen.b(), t.value);
        CHECK(curve.interval() == chosen);
        CHECK(curve.degree() == n);
        CHECK(textbook::text(evaluate(curve, t)) ==
              textbook::bernstein_value(recipe.control_points, recipe.interval, t.value));
        CHECK(control_points(curve, recipe.interval) == recipe.curve());
        CHECK(control_points(monomial_form(recipe.curve()), chosen) == curve);
    }
}

TEST_CASE("the ends of a control polygon are values of the curve", "[conversion]") {
    Random random(255);
    for (int i = 0; i < 300; ++i) {
        const std::size_t n = random.below(7);
        const BezierRecipe recipe = bezier_map(random, n, Size::any);
        CHECK(evaluate(recipe.curve(), recipe.interval.a()) == recipe.control_points.front());
        CHECK(evaluate(recipe.curve(), recipe.interval.b()) == recipe.control_points.back());
    }
}

TEST_CASE("the monomial form keeps the formal degree", "[conversion]") {
    const std::vector<Coordinates> raised_constant(5, Coordinates{Rational(2, 3), 1});
    const PolynomialCurve curve = monomial_form(BezierCurve(raised_constant, Interval(3, -1)));
    CHECK(curve.degree() == 4);
    CHECK(curve.actual_degree() == 0);
    CHECK(curve.coefficients()[0] == raised_constant[0]);
}
