// DeRose, Goldman, Lounsbery: A Tutorial Introduction to Blossoming (1991), section 2: affine combinations,
// barycentric coordinates, affine maps. Coordinates are symbols; the abstract data types are then held
// against the same statements at random points.

#include <blossom/core/algebra/sparse_algebra.hpp>
#include <blossom/core/geometry/affine_map.hpp>

#include "support/failure.hpp"
#include "support/map_printing.hpp"
#include "support/number_generators.hpp"
#include "support/symbolic.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

using SymbolicPoint = Symbols;

SymbolicPoint combined(const Symbols& weights, const std::vector<SymbolicPoint>& points) {
    SymbolicPoint sum(points.front().size(), 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += weights[i] * points[i][j];
    }
    return sum;
}

/// Twice the signed area of a triangle.
Symbol area(const SymbolicPoint& p, const SymbolicPoint& q, const SymbolicPoint& r) {
    return (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]);
}

geometry::Point random_point(Random& random, const geometry::Space& space) {
    Coordinates coordinates;
    for (std::size_t i = 0; i < space.dimension(); ++i) coordinates.push_back(small_rational(random));
    return space.point(std::move(coordinates));
}

}  // namespace

TEST_CASE("derose-affine-comb", "[statement]") {
    for (std::size_t n = 2; n <= 5; ++n) {
        Variables variables;
        const Symbols weights = variables.next(n);
        const Symbols shift = variables.next(2);
        std::vector<SymbolicPoint> points, moved;
        for (std::size_t i = 0; i < n; ++i) {
            points.push_back(variables.next(2));
            moved.push_back({points[i][0] + shift[0], points[i][1] + shift[1]});
        }
        const SymbolicPoint before = combined(weights, points), after = combined(weights, moved);
        for (std::size_t j = 0; j < 2; ++j) {
            CHECK(after[j] - (before[j] + shift[j]) == (sum(weights) - 1) * shift[j]);
        }
    }
    Random random(901);
    const geometry::Space plane(2);
    for (int round = 0; round < 20; ++round) {
        const geometry::Vector shift = random_point(random, plane) - plane.origin();
        std::vector<geometry::Point> points, moved;
        std::vector<Rational> weights{1};
        for (int i = 0; i < 4; ++i) {
            points.push_back(random_point(random, plane));
            moved.push_back(points.back() + shift);
            if (i == 0) continue;
            weights.push_back(small_rational(random));
            weights[0] -= weights.back();
        }
        CHECK(affine_combination(moved, weights) == affine_combination(points, weights) + shift);
        weights[0] += 1;
        CHECK(failure_code([&] { affine_combination(points, weights); }) == ErrorCode::not_affine);
    }
}

TEST_CASE("derose-fig1", "[statement]") {
    // p breaks the segment p1 p2 in the ratio a2 : a1, signed.
    Variables variables;
    const SymbolicPoint p1 = variables.next(2), p2 = variables.next(2);
    const Symbol a2 = variables.next();
    const Symbol a1 = 1 - a2;
    const SymbolicPoint p = combined({a1, a2}, {p1, p2});
    for (std::size_t j = 0; j < 2; ++j) {
        CHECK(p[j] - p1[j] == a2 * (p2[j] - p1[j]));
        CHECK(p2[j] - p[j] == a1 * (p2[j] - p1[j]));
    }
    Random random(902);
    const geometry::Space space(3);
    const geometry::Point first = random_point(random, space), second = random_point(random, space);
    const geometry::Simplex segment({first, second});
    const std::vector<Rational> weights{Rational(5, 4), Rational(-1, 4)};
    CHECK(segment.point(weights) - first == Rational(-1, 4) * (second - first));
    CHECK(second - segment.point(weights) == Rational(5, 4) * (second - first));
}

TEST_CASE("derose-fig2", "[statement]") {
    // The signed areas of the triangles opposite to p1, p2, p3 have the ratio a1 : a2 : a3.
    Variables variables;
    const SymbolicPoint p1 = variables.next(2), p2 = variables.next(2), p3 = variables.next(2);
    const Symbol a2 = variables.next(), a3 = variables.next();
    const Symbol a1 = 1 - a2 - a3;
    const SymbolicPoint p = combined({a1, a2, a3}, {p1, p2, p3});
    CHECK(area(p, p2, p3) == a1 * area(p1, p2, p3));
    CHECK(area(p1, p, p3) == a2 * area(p1, p2, p3));
    CHECK(area(p1, p2, p) == a3 * area(p1, p2, p3));
}

TEST_CASE("derose-barycentric", "[statement]") {
    // Existence: p times twice the area is the combination with the areas as weights, and these have its sum.
    Variables variables;
    const SymbolicPoint p1 = variables.next(2), p2 = variables.next(2), p3 = variables.next(2),
                        p = variables.next(2);
    const Symbol whole = area(p1, p2, p3);
    const Symbols weights{area(p, p2, p3), area(p1, p, p3), area(p1, p2, p)};
    const SymbolicPoint scaled_point = combined(weights, {p1, p2, p3});
    CHECK(sum(weights) == whole);
    for (std::size_t j = 0; j < 2; ++j) CHECK(scaled_point[j] == whole * p[j]);
    // Uniqueness: weights of sum 0 that combine to 0 vanish where the area does not.
    const Symbol x = variables.next(), y = variables.next();
    const SymbolicPoint zero = combined({-x - y, x, y}, {p1, p2, p3});
    CHECK(zero[0] * (p3[1] - p1[1]) - zero[1] * (p3[0] - p1[0]) == x * whole);
    CHECK(zero[1] * (p2[0] - p1[0]) - zero[0] * (p2[1] - p1[1]) == y * whole);

    // In any dimension, and for points of a larger space.
    Random random(903);
    for (std::size_t s = 1; s <= 4; ++s) {
        const geometry::Space space(s), larger(s + 1);
        for (const geometry::Space& where : {space, larger}) {
            for (int round = 0; round < 10; ++round) {
                std::vector<geometry::Point> vertices;
                for (std::size_t k = 0; k <= s; ++k) vertices.push_back(random_point(random, where));
                std::vector<Rational> expected{1};
                for (std::size_t k = 1; k <= s; ++k) {
                    expected.push_back(small_rational(random));
                    expected[0] -= expected.back();
                }
                const geometry::Point q = affine_combination(vertices, expected);
                try {
                    CHECK(geometry::Simplex(vertices).barycentric(q) == expected);
                } catch (const Error& error) {
                    CHECK(error.code() == ErrorCode::degenerate_simplex);
                }
                vertices.back() = affine_combination(std::span(vertices).first(1), std::vector<Rational>{1});
                CHECK(failure_code([&] { geometry::Simplex{vertices}; }) == ErrorCode::degenerate_simplex);
            }
        }
    }
}

TEST_CASE("derose-affine-map", "[statement]") {
    Variables variables;
    const Symbols m = variables.next(4), c = variables.next(2);
    const auto map = [&](const SymbolicPoint& x) -> SymbolicPoint {
        return {m[0] * x[0] + m[1] * x[1] + c[0], m[2] * x[0] + m[3] * x[1] + c[1]};
    };
    for (std::size_t n = 2; n <= 4; ++n) {
        std::vector<SymbolicPoint> points, images;
        Symbols weights{1};
        for (std::size_t i = 0; i < n; ++i) {
            points.push_back(variables.next(2));
            images.push_back(map(points.back()));
            if (i == 0) continue;
            weights.push_back(variables.next());
            weights[0] -= weights.back();
        }
        CHECK(map(combined(weights, points)) == combined(weights, images));
    }
    // x^2 is not affine: at the middle of 0 and 2.
    const std::vector<Rational> halves(2, Rational(1, 2));
    CHECK(halves[0] * 0 * 0 + halves[1] * 2 * 2 != pow(halves[0] * 0 + halves[1] * 2, 2));

    // A map that is affine is the one with the same images of a simplex.
    Random random(904);
    const geometry::Space plane(2), space(3);
    const geometry::Simplex domain({plane.point({0, 0}), plane.point({1, 2}), plane.point({3, -1})});
    const geometry::AffineMap first(
        domain, {random_point(random, space), random_point(random, space), random_point(random, space)});
    const geometry::Simplex other({plane.point({5, 5}), plane.point({6, 5}), plane.point({5, 7})});
    std::vector<geometry::Point> images;
    for (const geometry::Point& vertex : other.vertices()) images.push_back(first(vertex));
    const geometry::AffineMap second(other, images);
    for (int round = 0; round < 10; ++round) {
        const geometry::Point p = random_point(random, plane);
        CHECK(first(p) == second(p));
    }
}
