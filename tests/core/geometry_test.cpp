#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/core/geometry/coordinate_free_blossom.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include "core_test.hpp"

// The abstract data types of affine geometry.

namespace {

geometry::Point random_point(Random& random, const geometry::Space& space) {
    Coordinates coordinates;
    for (std::size_t i = 0; i < space.dimension(); ++i) coordinates.push_back(small_rational(random));
    return space.point(std::move(coordinates));
}

std::vector<geometry::Point> random_points(Random& random, const geometry::Space& space, std::size_t n) {
    std::vector<geometry::Point> points;
    for (std::size_t i = 0; i < n; ++i) points.push_back(random_point(random, space));
    return points;
}

/// The three corners of a triangle.
geometry::Simplex triangle(const geometry::Space& plane) {
    return geometry::Simplex({plane.point({1, 0}), plane.point({3, 1}), plane.point({0, 2})});
}

}  // namespace

TEST_CASE("geometry: points and vectors of a space") {
    const geometry::Space plane(2, "plane");
    const geometry::Point p = plane.point({1, 2}), q = plane.point({3, 5});
    CHECK(q - p == plane.vector({2, 3}));
    CHECK(p + (q - p) == q);
    CHECK(q - (q - p) == p);
    CHECK(p - p == plane.vector({0, 0}));
    CHECK(Rational(1, 2) * (q - p) == plane.vector({1, Rational(3, 2)}));
    CHECK((q - p) - (p - q) == plane.vector({4, 6}));
    CHECK(-(q - p) == p - q);
    CHECK(plane.origin() == plane.point({0, 0}));
    CHECK(failure_code([&] { plane.point({1}); }) == ErrorCode::mismatched_dimensions);
    CHECK(failure_code([&] { plane.vector({1, 2, 3}); }) == ErrorCode::mismatched_dimensions);
}

TEST_CASE("geometry: points of different spaces do not mix, also of the same dimension") {
    const geometry::Space plane(2, "plane"), other(2, "other"), copy = plane;
    const geometry::Point p = plane.point({1, 2}), q = other.point({1, 2});
    CHECK(p != q);
    CHECK(plane != other);
    CHECK(copy == plane);
    CHECK(copy.point({1, 2}) == p);
    const auto error = failure([&] { p - q; });
    CHECK(error->code() == ErrorCode::different_spaces);
    CHECK(error->message() ==
          "a point or vector of the space other of dimension 2 stands where one of the space plane of "
          "dimension 2 is needed");
    const geometry::Vector v = other.vector({1, 1});
    CHECK(failure_code([&] { p + v; }) == ErrorCode::different_spaces);
    CHECK(failure_code([&] { v + plane.vector({1, 1}); }) == ErrorCode::different_spaces);
    const std::vector<geometry::Point> mixed{p, q};
    const std::vector<Rational> halves(2, Rational(1, 2));
    CHECK(failure_code([&] { affine_combination(mixed, halves); }) == ErrorCode::different_spaces);
    CHECK(failure_code([&] { geometry::Simplex{mixed}; }) == ErrorCode::different_spaces);
    const geometry::Simplex domain = triangle(plane);
    CHECK(failure_code([&] { domain.barycentric(q); }) == ErrorCode::different_spaces);
    CHECK(failure_code([&] { domain.barycentric(v); }) == ErrorCode::different_spaces);
    const geometry::AffineMap map(domain, {q, q, q});
    CHECK(failure_code([&] { map(q); }) == ErrorCode::different_spaces);
    CHECK(failure_code([&] { geometry::AffineMap(domain, {p, q, p}); }) == ErrorCode::different_spaces);
    CHECK(failure_code([&] { composed(map, map); }) == ErrorCode::different_spaces);
    const geometry::Blossom b = geometry::Blossom::from_affine_map(map);
    CHECK(failure_code([&] { b(std::vector{q}); }) == ErrorCode::different_spaces);
    const std::vector<geometry::Point> net{p, q, p};
    CHECK(failure_code([&] { geometry::Blossom::from_bezier_net(domain, 1, net); }) ==
          ErrorCode::different_spaces);
}

TEST_CASE("geometry: weights of an affine combination must sum to one") {
    const geometry::Space plane(2);
    const std::vector<geometry::Point> points{plane.point({0, 0}), plane.point({2, 4})};
    const std::vector<Rational> good{Rational(3, 2), Rational(-1, 2)}, bad{1, 1}, few{1};
    CHECK(affine_combination(points, good) == plane.point({-1, -2}));
    const auto error = failure([&] { affine_combination(points, bad); });
    CHECK(error->code() == ErrorCode::not_affine);
    CHECK(error->message() == "the weights of an affine combination have the sum 2, which must be 1");
    CHECK(failure_code([&] { affine_combination(points, few); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([&] { geometry::affine_combination({}, {}); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([&] { triangle(plane).point(std::vector<Rational>{1, 1, 1}); }) ==
          ErrorCode::not_affine);
}

TEST_CASE("geometry: a degenerate simplex says which vertices are dependent") {
    const geometry::Space space(3);
    const auto error = failure([&] {
        geometry::Simplex(
            {space.point({0, 0, 0}), space.point({0, 1, 0}), space.point({1, 1, 1}), space.point({2, 2, 2})});
    });
    CHECK(error->code() == ErrorCode::degenerate_simplex);
    CHECK(error->message() == "the vertices 0, 2 and 3 are affinely dependent");
    CHECK(failure_code([&] { geometry::Simplex({}); }) == ErrorCode::wrong_arity);

    // A triangle in space, whose affine hull is a plane.
    const geometry::Simplex flat({space.point({0, 0, 0}), space.point({1, 0, 1}), space.point({0, 1, 1})});
    CHECK(flat.dimension() == 2);
    CHECK(flat.barycentric(space.point({1, 1, 2})) == Coordinates{-1, 1, 1});
    CHECK(failure_code([&] { flat.barycentric(space.point({0, 0, 1})); }) == ErrorCode::outside_domain);
}

TEST_CASE("geometry: barycentric coordinates are the weights, in any dimension and in larger spaces") {
    Random random(840);
    for (std::size_t s = 1; s <= 4; ++s) {
        for (const std::size_t around : {s, s + 1}) {
            const geometry::Space space(around);
            std::vector<geometry::Point> vertices{space.origin()};
            Coordinates weights{1};
            for (std::size_t k = 0; k < s; ++k) {
                Coordinates coordinates = random_point(random, space).coordinates();
                coordinates[k] += 1000;
                vertices.push_back(space.point(coordinates));
                weights.push_back(small_rational(random));
                weights[0] -= weights.back();
            }
            const geometry::Vector shift = random_point(random, space) - space.origin();
            for (geometry::Point& vertex : vertices) vertex = vertex + shift;
            CHECK(geometry::Simplex(vertices).barycentric(affine_combination(vertices, weights)) == weights);
        }
    }
}

TEST_CASE("geometry: affine maps from the images of a simplex") {
    Random random(841);
    const geometry::Space plane(2, "plane"), space(3, "space"), line(1, "line");
    const geometry::Simplex domain = triangle(plane);
    for (int round = 0; round < 20; ++round) {
        const geometry::AffineMap map(domain, random_points(random, space, 3));
        for (std::size_t k = 0; k < 3; ++k) CHECK(map(domain.vertices()[k]) == map.images()[k]);
        const geometry::Point p = random_point(random, plane), q = random_point(random, plane);
        CHECK(map(q - p) == map(q) - map(p));
        const std::vector<geometry::Point> points{p, q}, images{map(p), map(q)};
        const Rational a = small_rational(random);
        const std::vector<Rational> weights{1 - a, a};
        CHECK(map(affine_combination(points, weights)) == affine_combination(images, weights));
        // An affine map is a blossom of one argument.
        const geometry::Blossom b = geometry::Blossom::from_affine_map(map);
        CHECK(b.degree() == 1);
        CHECK(b(std::vector{p}) == map(p));
        CHECK(b(std::vector<geometry::Point>{}, std::vector{q - p}) == map(q - p));

        const geometry::Simplex frame(
            {space.point({0, 0, 0}), space.point({1, 0, 0}), space.point({0, 1, 0}), space.point({0, 0, 1})});
        const geometry::AffineMap down(frame, random_points(random, line, 4));
        CHECK(composed(down, map)(p) == down(map(p)));
    }
    CHECK(failure_code([&] { geometry::AffineMap(domain, random_points(random, space, 2)); }) ==
          ErrorCode::wrong_arity);
}

TEST_CASE("geometry: one blossom from a net, a polynomial, a callable and its net over another triangle") {
    Random random(842);
    const geometry::Space plane(2, "plane"), space(2, "range");
    const std::vector<std::string> names{"x", "y"};
    const std::vector<SparsePolynomial> coordinates{
        parse_polynomial("x^3 - 2x*y + 1/3 y^2", names).polynomial,
        parse_polynomial("x^2*y + y - 5", names).polynomial};
    const auto map = [&](const geometry::Point& p) {
        return space.point({coordinates[0](p.coordinates()), coordinates[1](p.coordinates())});
    };
    const geometry::Simplex domain = triangle(plane);
    const geometry::Blossom from_polynomial =
        geometry::Blossom::from_polynomial(plane, space, 3, coordinates);
    const geometry::Blossom from_values = geometry::Blossom::from_values(domain, 3, map);
    const geometry::Blossom from_net =
        geometry::Blossom::from_bezier_net(domain, 3, from_polynomial.bezier_net(domain));
    for (int round = 0; round < 10; ++round) {
        const std::vector<geometry::Point> arguments = random_points(random, plane, 3);
        const geometry::Point value = from_polynomial(arguments);
        CHECK(from_values(arguments) == value);
        CHECK(from_net(arguments) == value);
        const geometry::Point p = arguments[0];
        CHECK(from_net.evaluate(p) == map(p));
        CHECK(from_net(std::vector(3, p)) == map(p));

        // f(p, q, r) - f(p, q, s) = f(p, q, r - s), and the derivative.
        const geometry::Vector v = arguments[1] - arguments[2];
        const std::vector<geometry::Point> two{p, p};
        CHECK(from_net(two, std::vector{v}) ==
              from_net(std::vector{p, p, arguments[1]}) - from_net(std::vector{p, p, arguments[2]}));
        CHECK(from_net.derivative(p, std::vector{v}) == Rational(3) * from_net(two, std::vector{v}));
        CHECK(from_net.derivative(p, std::vector(4, v)) == space.vector({0, 0}));
    }
    CHECK(from_net.domain().front() == domain);
    CHECK(from_net.range() == space);
    const std::vector<geometry::Point> few = random_points(random, plane, 2);
    CHECK(failure_code([&] { from_net(few); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([&] { from_net(random_points(random, plane, 3), std::vector<geometry::Vector>()); }) ==
          ErrorCode::wrong_arity);
    CHECK(failure_code([&] { from_net(geometry::PointLists()); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([&] { geometry::Blossom::from_polynomial(plane, space, 2, coordinates); }) ==
          ErrorCode::degree_too_low);
    CHECK(failure_code([&] {
              geometry::Blossom::from_polynomial(plane, plane, 3, std::span(coordinates).first(1));
          }) == ErrorCode::mismatched_dimensions);
    CHECK(failure_code([&] { geometry::Blossom::from_bezier_net(domain, 3, few); }) ==
          ErrorCode::incomplete_net);
    CHECK(failure_code([&] { geometry::Blossom::from_bezier_net(domain, 3, {}); }) == ErrorCode::wrong_arity);
}

TEST_CASE("geometry: the blossom of a segment of a B-spline") {
    Random random(843);
    const geometry::Space line(1, "line"), plane(2, "plane");
    const KnotVector knots(3, {0, 0, 0, 0, 1, 3, 4, 4, 4, 4}, 6);
    const std::vector<geometry::Point> points = random_points(random, plane, 6);
    std::vector<Coordinates> coordinates;
    for (const geometry::Point& point : points) coordinates.push_back(point.coordinates());
    const BSplineCurve curve(knots, coordinates);
    for (const std::size_t span : knots.spans()) {
        const geometry::Blossom f = geometry::Blossom::from_bspline(line, knots, points, span);
        // The control points of the segment are the values at consecutive knots.
        for (std::size_t j = knots.first_point(span); j <= knots.first_point(span) + 3; ++j) {
            std::vector<geometry::Point> window;
            for (const Rational& knot : knots.window(j)) window.push_back(line.point({knot}));
            CHECK(f(window) == points[j]);
        }
        const Rational t = (knots[span] + knots[span + 1]) / 2;
        CHECK(f.evaluate(line.point({t})).coordinates() == evaluate(curve, t));
    }
    CHECK(failure_code([&] { geometry::Blossom::from_bspline(plane, knots, points, 3); }) ==
          ErrorCode::mismatched_dimensions);
    CHECK(failure_code([&] { geometry::Blossom::from_bspline(line, knots, points, 0); }) ==
          ErrorCode::outside_domain);
}

TEST_CASE("geometry: a tensor product over segments of two spaces") {
    Random random(844);
    const geometry::Space u(1, "u"), v(1, "v"), space(3, "space");
    const std::vector<geometry::Simplex> domain{geometry::Simplex({u.point({0}), u.point({2})}),
                                                geometry::Simplex({v.point({1}), v.point({-1})})};
    const std::vector<std::size_t> degrees{2, 1};
    const std::vector<geometry::Point> net = random_points(random, space, 6);
    const geometry::Blossom f = geometry::Blossom::from_bezier_net(domain, degrees, net);
    CHECK(f({{u.point({0}), u.point({2})}, {v.point({-1})}}) == net[3]);
    const geometry::Point at_u = u.point({Rational(1, 3)}), at_v = v.point({5});
    CHECK(f({{at_u, at_u}, {at_v}}) == f.evaluate(std::vector{at_u, at_v}));
    CHECK(f({{at_u}, {at_v}}, {{u.vector({2})}, {}}) ==
          f({{at_u, u.point({2})}, {at_v}}) - f({{at_u, u.point({0})}, {at_v}}));
    CHECK(f({{at_u, at_u}, {}}, {{}, {v.vector({6})}}) ==
          f({{at_u, at_u}, {v.point({5})}}) - f({{at_u, at_u}, {v.point({-1})}}));
    CHECK(failure_code([&] { f({{at_u, at_v}, {at_v}}); }) == ErrorCode::different_spaces);
    CHECK(failure_code([&] { f.bezier_net(domain[0]); }) == ErrorCode::wrong_arity);
}
