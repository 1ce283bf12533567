#include "core_test.hpp"

TEST_CASE("raising the degree by r keeps the map and is r times raising it by one", "[degree_elevation]") {
    Random random(311);
    for (std::size_t i = 0; i < 270; ++i) {
        const std::size_t n = i % 9;
        const std::size_t r = random.below(6);
        const BezierCurve curve = bezier_map(random, n, i % 4 == 0 ? Size::any : Size::small).curve();
        CAPTURE(i, n, r);
        const BezierCurve raised = elevate(curve, r);
        CHECK(raised.degree() == n + r);
        CHECK(raised.interval() == curve.interval());
        CHECK(expanded(raised) == expanded(curve));
        BezierCurve by_ones = curve;
        for (std::size_t step = 0; step < r; ++step) by_ones = elevate(by_ones, 1);
        CHECK(raised == by_ones);
        CHECK(raised.control_points()[0] == curve.control_points()[0]);
        CHECK(raised.control_points()[n + r] == curve.control_points()[n]);
    }
}

TEST_CASE("raising by one takes neighbours in the ratio k to n + 1 - k", "[degree_elevation]") {
    Random random(312);
    for (std::size_t i = 0; i < 90; ++i) {
        const std::size_t n = i % 9;
        const BezierRecipe recipe = bezier_map(random, n, Size::any);
        const BezierCurve raised = elevate(recipe.curve(), 1);
        for (std::size_t k = 0; k <= n + 1; ++k) {
            for (std::size_t j = 0; j < recipe.dimension(); ++j) {
                Rational expected;
                if (k > 0) expected += Rational(k, n + 1) * recipe.control_points[k - 1][j];
                if (k <= n) expected += Rational(n + 1 - k, n + 1) * recipe.control_points[k][j];
                CHECK(raised.control_points()[k][j] == expected);
            }
        }
    }
}

TEST_CASE("raising commutes with the change of basis", "[degree_elevation]") {
    Random random(313);
    for (std::size_t i = 0; i < 180; ++i) {
        const PolynomialRecipe recipe = polynomial_map(random, i % 9, i % 4 == 0 ? Size::any : Size::small);
        const std::size_t r = random.below(6);
        const Interval over = interval(random, Size::small);
        const PolynomialCurve raised = elevate(recipe.curve(), r);
        CHECK(raised.degree() == recipe.degree + r);
        CHECK(raised == PolynomialCurve(recipe.coefficients, recipe.degree + r));
        CHECK(control_points(raised, over) == elevate(control_points(recipe.curve(), over), r));
    }
}

TEST_CASE("a degree is raised within its limit", "[degree_elevation]") {
    Limits limits;
    limits.degree = 5;
    const BezierCurve curve(std::vector<Coordinates>{{1}, {2}, {4}});
    const PolynomialCurve polynomial(std::vector<Coordinates>{{1}, {2}, {4}});
    CHECK(elevate(curve, 3, limits).degree() == 5);
    for (const std::size_t r : {std::size_t{4}, std::size_t{6}, ~std::size_t{0}}) {
        CHECK(failure_code([&] { elevate(curve, r, limits); }) == ErrorCode::limit_exceeded);
        CHECK(failure_code([&] { elevate(polynomial, r, limits); }) == ErrorCode::limit_exceeded);
    }
}
