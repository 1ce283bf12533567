#include <blossom/core/nurbs/rational_curve.hpp>
#include "core_test.hpp"

namespace {

/// Numerators N_k with C^(k) = N_k / w^(k+1), by (N / w^k)' = (N' w - k N w') / w^(k+1).
Polynomial derivative_numerator(Polynomial numerator, const Polynomial& weight, std::size_t order) {
    for (std::size_t k = 1; k <= order; ++k) {
        numerator = derivative(numerator) * weight - Polynomial(Rational(k)) * numerator * derivative(weight);
    }
    return numerator;
}

}  // namespace

TEST_CASE("the derivatives of a rational map are those of the quotient of polynomials", "[rational_curve]") {
    Random random(361);
    std::size_t checked = 0;
    for (std::size_t i = 0; i < 240; ++i) {
        const std::size_t n = i % 9;
        PolynomialCurve map = polynomial_map(random, n, i % 4 == 0 ? Size::any : Size::small).curve();
        while (map.dimension() < 2) map = polynomial_map(random, n, Size::small).curve();
        const Rational t = number(random, Size::small);
        const std::size_t order = random.below(6);
        const std::vector<Polynomial> coordinates = expanded(map);
        const Polynomial& weight = coordinates.back();
        CAPTURE(i, n, t, order, weight);
        if (weight(t).is_zero()) {
            CHECK(failure_code([&] { rational_derivative(map, order, t); }) == ErrorCode::zero_weight);
            continue;
        }
        const Coordinates value = rational_derivative(map, order, t);
        REQUIRE(value.size() + 1 == coordinates.size());
        for (std::size_t j = 0; j < value.size(); ++j) {
            CHECK(value[j] * pow(weight(t), order + 1) ==
                  derivative_numerator(coordinates[j], weight, order)(t));
        }
        CHECK(rational_derivative(control_points(map, interval(random, Size::small)), order, t) == value);
        ++checked;
    }
    CHECK(checked > 100);
}

TEST_CASE("the derivative of order zero is the projected value", "[rational_curve]") {
    Random random(362);
    for (std::size_t i = 0; i < 60; ++i) {
        BezierRecipe recipe = bezier_map(random, i % 9, Size::small);
        for (auto& point : recipe.control_points) point.push_back(1 + abs(number(random, Size::small)));
        const Rational t = recipe.interval.a() + (recipe.interval.b() - recipe.interval.a()) / 3;
        CHECK(rational_derivative(recipe.curve(), 0, t) == projected(evaluate(recipe.curve(), t)));
    }
}

TEST_CASE("a point and its weight are converted to homogeneous coordinates and back", "[rational_curve]") {
    Random random(363);
    for (std::size_t i = 0; i < 200; ++i) {
        Coordinates point;
        for (std::uint64_t j = 1 + random.below(3); j > 0; --j) point.push_back(number(random, Size::any));
        const Rational weight = number(random, Size::any);
        if (weight.is_zero()) continue;
        const Coordinates homogeneous = homogeneous_point(point, weight);
        CHECK(homogeneous.back() == weight);
        CHECK(homogeneous.front() == weight * point.front());
        CHECK(projected(homogeneous) == point);
    }
}

TEST_CASE("a point at infinity has no Euclidean coordinates", "[rational_curve]") {
    CHECK(failure_code([] { projected({1, 2, 0}); }) == ErrorCode::zero_weight);
    CHECK(failure_code([] { homogeneous_point({1, 2}, 0); }) == ErrorCode::zero_weight);
    CHECK(failure_code([] { projected({3}); }) == ErrorCode::mismatched_dimensions);
    CHECK(failure_code([] { projected({}); }) == ErrorCode::mismatched_dimensions);

    const BezierCurve half_circle(std::vector<Coordinates>{{0, -2, 2}, {2, 0, 0}, {0, 2, 2}},
                                  Interval(-1, 1));
    CHECK(rational_derivative(half_circle, 0, 0) == Coordinates{1, 0});
    CHECK(rational_derivative(half_circle, 1, 0) == Coordinates{0, 2});
    CHECK(rational_derivative(half_circle, 2, 0) == Coordinates{-4, 0});
    const BezierCurve pole(std::vector<Coordinates>{{1, -1}, {1, 1}});
    CHECK(failure_code([&] { rational_derivative(pole, 1, Rational(1, 2)); }) == ErrorCode::zero_weight);
    CHECK(failure_code([&] { rational_derivative(pole, 1, 0); }) == std::nullopt);
}

TEST_CASE(
    "fj-ex1-quarter, fj-ex1-quarter-quartic: the printed quarter of the circle, as a quadratic and as a "
    "quartic",
    "[rational_curve]") {
    const PolynomialCurve circle(std::vector<Coordinates>{{1, 0, 1}, {0, 2, 0}, {-1, 0, 1}});
    const auto printed = [](const std::vector<std::pair<Coordinates, Rational>>& vertices) {
        std::vector<Coordinates> points;
        for (const auto& [point, weight] : vertices) points.push_back(homogeneous_point(point, weight));
        return BezierCurve(points);
    };
    CHECK(control_points(circle, {}) == printed({{{1, 0}, 1}, {{1, 1}, 1}, {{0, 1}, 2}}));
    CHECK(elevate(control_points(circle, {}), 2) ==
          printed({{{1, 0}, 1},
                   {{1, Rational(1, 2)}, 1},
                   {{Rational(5, 7), Rational(6, 7)}, Rational(7, 6)},
                   {{Rational(1, 3), 1}, Rational(3, 2)},
                   {{0, 1}, 2}}));
}
