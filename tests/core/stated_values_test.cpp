#include <blossom/core/maps/hermite_curve.hpp>
#include <blossom/core/maps/taylor_curve.hpp>
#include <blossom/core/spline/progressive.hpp>
#include "core_test.hpp"

namespace {

/// Checks that each point of `curve` is its stated multiple of the textbook's blossom of the coefficients.
template <OnePolynomial Curve>
void check_stated(const Curve& curve, const PolynomialRecipe& recipe) {
    std::vector<Coordinates> coefficients = recipe.coefficients;
    coefficients.resize(recipe.degree + 1, Coordinates(recipe.dimension()));
    const std::vector<StatedValue> stated = stated_values(curve);
    CHECK(stated.size() == recipe.degree + 1);
    for (const auto& [name, index, arguments, multiple, point] : stated) {
        CAPTURE(name, index, arguments, multiple);
        Coordinates divided = point;
        for (Rational& coordinate : divided) coordinate /= Rational(multiple);
        CHECK(textbook::text(divided) == textbook::blossom_of_coefficients(coefficients, arguments));
    }
}

}  // namespace

TEST_CASE("the points of every representation are the blossom values that it states", "[stated]") {
    Random random(341);
    for (std::size_t i = 0; i < 42; ++i) {
        const std::size_t n = i % 7;
        const PolynomialRecipe recipe = polynomial_map(random, n, Size::small);
        const PolynomialCurve curve = recipe.curve();
        const Interval over = interval(random, Size::small);
        CAPTURE(i, n, over.a(), over.b());
        const BezierCurve bezier = control_points(curve, over);
        std::vector<Rational> knots;
        for (std::size_t k = 0; k < 2 * n; ++k) knots.emplace_back(k * k);
        check_stated(curve, recipe);
        check_stated(bezier, recipe);
        check_stated(taylor_form(curve, over.a()), recipe);
        check_stated(hermite_form(bezier, (i * 5) % (n + 2)), recipe);
        check_stated(progressive_form(curve, knots), recipe);
    }
}
