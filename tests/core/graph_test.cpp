#include <blossom/core/spline/graph.hpp>
#include "core_test.hpp"

#include <blossom/core/spline/spline_split.hpp>

namespace {

Coordinates with_first(const Rational& t, const Coordinates& rest) {
    Coordinates point{t};
    point.insert(point.end(), rest.begin(), rest.end());
    return point;
}

}  // namespace

TEST_CASE("the graph passes through (t, P(t)) in every representation", "[graph]") {
    Random random(531);
    for (std::size_t i = 0; i < 80; ++i) {
        const PolynomialCurve curve = polynomial_map(random, i % 6, Size::small).curve();
        const BezierCurve bezier = bezier_map(random, i % 6, Size::small).curve();
        const BSplineCurve spline = testing::spline(random, i % 6).curve();
        const Rational t = number(random, Size::small);
        CHECK(evaluate(graph(curve), t) == with_first(t, evaluate(curve, t)));
        CHECK(evaluate(graph(bezier), t) == with_first(t, evaluate(bezier, t)));
        CHECK(graph(bezier).interval() == bezier.interval());
        const Rational inside = parameter(random, spline.knots());
        CHECK(evaluate(graph(spline), inside) == with_first(inside, evaluate(spline, inside)));
        CHECK(graph(spline).degree() == std::max<std::size_t>(spline.degree(), 1));
    }
}

TEST_CASE("with weights the first coordinate is t times the weight", "[graph]") {
    Random random(532);
    for (std::size_t i = 0; i < 60; ++i) {
        const PolynomialCurve curve = polynomial_map(random, i % 5, Size::small).curve();
        const BezierCurve bezier = bezier_map(random, i % 5, Size::small).curve();
        const BSplineCurve spline = testing::spline(random, i % 5).curve();
        const Rational t = number(random, Size::small);
        const auto expected = [](const Rational& at, const Coordinates& value) {
            return with_first(at * value.back(), value);
        };
        const GraphForm form = GraphForm::homogeneous;
        CHECK(evaluate(graph(curve, form), t) == expected(t, evaluate(curve, t)));
        CHECK(evaluate(graph(bezier, form), t) == expected(t, evaluate(bezier, t)));
        const Rational inside = parameter(random, spline.knots());
        CHECK(evaluate(graph(spline, form), inside) == expected(inside, evaluate(spline, inside)));
    }
}

TEST_CASE("part of a spline is the same map on a smaller domain", "[split]") {
    Random random(533);
    std::size_t checked = 0;
    for (int round = 0; round < 80; ++round) {
        const SplineRecipe recipe = testing::spline(random, random.below(6));
        const BSplineCurve curve = recipe.curve();
        Rational a = parameter(random, curve.knots());
        Rational b = parameter(random, curve.knots());
        if (a == b) continue;
        if (b < a) std::swap(a, b);
        const BSplineCurve part = restricted(curve, Interval(a, b));
        CHECK(part.knots().domain() == Interval(a, b));
        CHECK(part.knots().convention() == curve.knots().convention());
        for (int i = 1; i < 4; ++i) {
            const Rational t = a + (b - a) * i / 4;
            CHECK(evaluate(part, t) == textbook::value(recipe.oracle(), t));
        }
        CHECK(failure_code([&] { restricted(curve, Interval(b, a)); }) == ErrorCode::outside_domain);
        ++checked;
    }
    CHECK(checked > 40);
}

TEST_CASE("every node of de Boor's triangle is a blossom value", "[progressive]") {
    Random random(534);
    for (int round = 0; round < 40; ++round) {
        const SplineRecipe recipe = testing::spline(random, 1 + random.below(4));
        const BSplineCurve curve = recipe.curve();
        const std::size_t n = curve.degree();
        const std::size_t span = curve.knots().span_at(parameter(random, curve.knots()));
        const ProgressiveCurve piece = segment(curve, span);
        const std::vector<Argument> given = testing::arguments(random, n, Size::small);
        const auto levels = de_boor_pyramid(piece, given);
        REQUIRE(levels.size() == n + 1);
        for (std::size_t k = 0; k <= n; ++k) {
            REQUIRE(levels[k].size() == n + 1 - k);
            for (std::size_t l = 0; l <= n - k; ++l) {
                std::vector<Argument> at(given.begin(), given.begin() + static_cast<std::ptrdiff_t>(k));
                for (std::size_t i = k + l; i < n + l; ++i) at.emplace_back(Parameter(piece.knots()[i]));
                CHECK(levels[k][l] == blossom_value(piece, at));
            }
        }
        CHECK(failure_code([&] { de_boor_pyramid(piece, {}); }) == ErrorCode::wrong_arity);
    }
}
