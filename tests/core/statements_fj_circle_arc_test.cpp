// Fernandez-Jambrina: Inverse Relations for Blossoms and Parametrisations of Rational Curves and Surfaces
// (2024), example 1: the arc of the unit circle ((1 - t^2) / (1 + t^2), 2 t / (1 + t^2)) over [alpha, beta].
//
// alpha and beta are symbols. A printed point x / d with weight w stands for homogeneous coordinates X with X
// d = x w, which is how it is compared; the engine's own maps are compared at random ends.

#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/blossom/evaluation.hpp>
#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/curve/inverse_formula.hpp>
#include <blossom/core/nurbs/rational_curve.hpp>

#include "support/failure.hpp"
#include "support/map_generators.hpp"
#include "support/map_printing.hpp"
#include "support/symbolic_curves.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

const Symbol al = Symbol::variable(0);
const Symbol be = Symbol::variable(1);

/// A printed vertex: ((x, y) / divisor, weight).
struct Vertex {
    Symbol x;
    Symbol y;
    Symbol divisor;
    Symbol weight;
};

std::vector<Vertex> printed_quadratic() {
    return {{1 - al * al, 2 * al, 1 + al * al, 1 + al * al},
            {1 - al * be, al + be, 1 + al * be, 1 + al * be},
            {1 - be * be, 2 * be, 1 + be * be, 1 + be * be}};
}

std::vector<Vertex> printed_quartic() {
    const Symbol half = fraction(1, 2);
    const Symbol sixth = fraction(1, 6);
    const Symbol mixed = al * al + 4 * al * be + be * be;
    return {{1 - al * al, 2 * al, 1 + al * al, 1 + al * al},
            {2 - al * al - al * be, 3 * al + be, 2 + al * al + al * be, 1 + (al * al + al * be) * half},
            {6 - mixed, 6 * (al + be), 6 + mixed, 1 + mixed * sixth},
            {2 - al * be - be * be, al + 3 * be, 2 + al * be + be * be, 1 + (al * be + be * be) * half},
            {1 - be * be, 2 * be, 1 + be * be, 1 + be * be}};
}

/// The homogeneous coordinates of the vertices of formal degree n: blossom values of 1 - t^2, 2 t and 1 +
/// t^2.
std::vector<Symbols> homogeneous_vertices(std::size_t n) {
    std::vector<Symbols> result;
    for (Symbols coefficients : {Symbols{1, 0, -1}, Symbols{0, 2, 0}, Symbols{1, 0, 1}}) {
        coefficients.resize(n + 1, 0);
        result.push_back(end_values(SymbolicBlossom::of_coefficients(coefficients), al, be));
    }
    return result;
}

void check_vertices(const std::vector<Vertex>& printed) {
    const std::size_t n = printed.size() - 1;
    const std::vector<Symbols> homogeneous = homogeneous_vertices(n);
    for (std::size_t i = 0; i <= n; ++i) {
        CAPTURE(i);
        CHECK(homogeneous[2][i] == printed[i].weight);
        CHECK(homogeneous[0][i] * printed[i].divisor == printed[i].x * printed[i].weight);
        CHECK(homogeneous[1][i] * printed[i].divisor == printed[i].y * printed[i].weight);
    }
    const Symbol t = Symbol::variable(2);
    const Symbol length = pow(be - al, n);
    CHECK(bezier_value(homogeneous[0], al, be, t) == length * (1 - t * t));
    CHECK(bezier_value(homogeneous[1], al, be, t) == length * (2 * t));
    CHECK(bezier_value(homogeneous[2], al, be, t) == length * (1 + t * t));
}

/// (1 - t^2, 2 t, 1 + t^2).
const PolynomialCurve circle(std::vector<Coordinates>{{1, 0, 1}, {0, 2, 0}, {-1, 0, 1}});

struct WeightedPolygon {
    std::vector<Coordinates> points;
    Coordinates weights;
};

WeightedPolygon weighted(const BezierCurve& curve) {
    WeightedPolygon result;
    for (const Coordinates& point : curve.control_points().to_points()) {
        result.points.push_back(projected(point));
        result.weights.push_back(point.back());
    }
    return result;
}

Rational r(int p, int q) { return {p, q}; }

}  // namespace

TEST_CASE(
    "fj-ex1-quadratic: vertices and weights for all alpha and beta; alpha beta = -1 gives a point at "
    "infinity",
    "[statement]") {
    check_vertices(printed_quadratic());

    // The half circle: w_1 = 0, and b_1 is the homogeneous (2, 0; 0).
    const BezierCurve half = control_points(circle, {-1, 1});
    CHECK(half.control_points()[1] == Coordinates{2, 0, 0});
    CHECK(failure_code([&] { projected(half.control_points()[1]); }) == ErrorCode::zero_weight);
    CHECK(projected(evaluate(half, r(1, 3))) == Coordinates{r(4, 5), r(3, 5)});
    Random random(401);
    for (int i = 0; i < 60; ++i) {
        const Rational alpha = 1 + abs(number(random, Size::small));
        CHECK(control_points(circle, {alpha, -1 / alpha}).control_points()[1].back() == 0);
    }
}

TEST_CASE("fj-ex1-quartic: the same arc as a quartic, all five vertices and weights", "[statement]") {
    check_vertices(printed_quartic());

    Random random(402);
    for (int i = 0; i < 60; ++i) {
        const Interval over = interval(random, Size::any);
        const BezierCurve raised = elevate(control_points(circle, over), 2);
        CHECK(control_points(elevate(circle, 2), over) == raised);
        CHECK(control_points_from_values(4, over, [](const Rational& t) { return evaluate(circle, t); }) ==
              raised);
        const Coordinates ends{over.a(), over.b()};
        const auto printed = printed_quartic();
        for (std::size_t k = 0; k <= 4; ++k) {
            CHECK(raised.control_points()[k].back() == printed[k].weight(ends));
            if (printed[k].divisor(ends).is_zero()) continue;
            const Rational divisor = printed[k].divisor(ends);
            CHECK(projected(raised.control_points()[k]) ==
                  Coordinates{printed[k].x(ends) / divisor, printed[k].y(ends) / divisor});
        }
    }
}

TEST_CASE("fj-ex1-quarter: alpha = 0, beta = 1 has the polygon (1,0), (1,1), (0,1) and weights 1, 1, 2",
          "[statement]") {
    const WeightedPolygon arc = weighted(control_points(circle, {}));
    CHECK(arc.points == std::vector<Coordinates>{{1, 0}, {1, 1}, {0, 1}});
    CHECK(arc.weights == Coordinates{1, 1, 2});
}

TEST_CASE(
    "fj-ex1-quarter-quartic: as a quartic (1,0), (1,1/2), (5/7,6/7), (1/3,1), (0,1), weights 1, 1, 7/6, 3/2, "
    "2",
    "[statement]") {
    const WeightedPolygon arc = weighted(elevate(control_points(circle, {}), 2));
    CHECK(arc.points ==
          std::vector<Coordinates>{{1, 0}, {1, r(1, 2)}, {r(5, 7), r(6, 7)}, {r(1, 3), 1}, {0, 1}});
    CHECK(arc.weights == Coordinates{1, 1, r(7, 6), r(3, 2), 2});
}
