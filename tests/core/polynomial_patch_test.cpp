#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/core/algebra/sparse_algebra.hpp>
#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/patch/patch_conversion.hpp>
#include "core_test.hpp"

// Polynomials in several variables: their blossoms, and their conversion to control nets and back.

namespace {

SparsePolynomial polynomial_in_xy(std::string_view text) {
    const std::vector<std::string> names{"x", "y"};
    return parse_polynomial(text, names).polynomial;
}

/// A random polynomial map with the shape's degrees.
PolynomialPatch random_polynomial(Random& random, const std::vector<std::size_t>& dimensions) {
    const BezierPatch net = patch(random, dimensions, Size::small, 40).patch();
    return {net.shape(), net.control_net()};
}

Coordinates numbers_of(Random& random, std::size_t count, Size size) {
    Coordinates numbers;
    for (std::size_t i = 0; i < count; ++i) numbers.push_back(number(random, size));
    return numbers;
}

BarycentricFrame random_frame(Random& random, std::size_t dimension) {
    while (true) {
        std::vector<Coordinates> vertices;
        for (std::size_t k = 0; k <= dimension; ++k) {
            Coordinates& vertex = vertices.emplace_back();
            for (std::size_t j = 0; j < dimension; ++j) vertex.push_back(number(random, Size::small));
        }
        try {
            return BarycentricFrame(vertices);
        } catch (const Error& error) {
            if (error.code() != ErrorCode::degenerate_simplex) throw;
        }
    }
}

std::vector<BarycentricFrame> random_frames(Random& random, const NetShape& shape) {
    std::vector<BarycentricFrame> frames;
    for (std::size_t f = 0; f < shape.factors(); ++f)
        frames.push_back(random_frame(random, shape[f].dimension));
    return frames;
}

}  // namespace

TEST_CASE("polynomial patches: terms, coordinates and what does not fit") {
    const std::vector<SparsePolynomial> coordinates{polynomial_in_xy("x^2 + 3x*y - 2"),
                                                    polynomial_in_xy("1/2 y")};
    const PolynomialPatch patch(NetShape::simplex(2, 2), coordinates);
    CHECK(patch.coefficients().to_points() ==
          std::vector<Coordinates>{{-2, 0}, {0, 0}, {0, Rational(1, 2)}, {1, 0}, {3, 0}, {0, 0}});
    CHECK(patch.coordinate(0) == coordinates[0]);
    CHECK(patch.coordinate(1) == coordinates[1]);
    CHECK(failure_code([&] { PolynomialPatch(NetShape::simplex(2, 1), coordinates); }) ==
          ErrorCode::degree_too_low);
    CHECK(failure_code([&] { PolynomialPatch(NetShape::simplex(1, 2), coordinates); }) ==
          ErrorCode::wrong_arity);
    CHECK(failure_code([&] { PolynomialPatch(NetShape::simplex(2, 2), std::vector<SparsePolynomial>()); }) ==
          ErrorCode::wrong_arity);
    const std::vector<std::size_t> degrees{1, 2};
    CHECK(failure_code([&] { PolynomialPatch(NetShape::tensor(degrees), coordinates); }) ==
          ErrorCode::degree_too_low);

    // x^2 + 3xy - 2 at (1, 2) and (3, -1): 3 + 3 (1 * (-1) + 2 * 3) / 2 - 2.
    const std::vector<Coordinates> points{point_argument(Coordinates{1, 2}),
                                          point_argument(Coordinates{3, -1})};
    CHECK(blossom_value(patch, {points}) == Coordinates{Rational(17, 2), Rational(1, 4)});

    const Coordinates vector = vector_argument(Coordinates{1, 2});
    CHECK(failure_code([&] { evaluate(patch, {vector}); }) == ErrorCode::not_affine);
    CHECK(failure_code([&] { derivative_patch(patch, {points}); }) == ErrorCode::not_affine);
}

TEST_CASE("polynomial patches: values, derivatives, the blossom on the diagonal") {
    Random random(821);
    for (const auto& dimensions : products_of_simplices()) {
        const PolynomialPatch patch = random_polynomial(random, dimensions);
        const NetShape& shape = patch.shape();
        PatchPoint point;
        std::vector<Rational> numbers;
        PatchArguments directions;
        std::vector<SparsePolynomial> expected;
        for (std::size_t j = 0; j < patch.dimension(); ++j) expected.push_back(patch.coordinate(j));
        for (std::size_t f = 0; f < shape.factors(); ++f) {
            auto& list = directions.emplace_back();
            const std::size_t first = numbers.size();
            for (std::uint64_t k = random.below(3); k > 0; --k) {
                const Coordinates direction = numbers_of(random, shape[f].dimension, Size::small);
                list.push_back(vector_argument(direction));
                for (SparsePolynomial& polynomial : expected) {
                    SparsePolynomial sum;
                    for (std::size_t i = 0; i < direction.size(); ++i)
                        sum += direction[i] * derivative(polynomial, first + i);
                    polynomial = sum;
                }
            }
            const Coordinates own = numbers_of(random, shape[f].dimension, Size::any);
            numbers.insert(numbers.end(), own.begin(), own.end());
            point.push_back(point_argument(own));
        }
        const Coordinates value = evaluate(patch, point);
        CHECK(blossom_value(patch, diagonal(shape, point)) == value);
        const Coordinates slope = derivative(patch, directions, point);
        const PolynomialPatch map = derivative_patch(patch, directions);
        for (std::size_t j = 0; j < patch.dimension(); ++j) {
            CHECK(value[j] == patch.coordinate(j)(numbers));
            CHECK(slope[j] == expected[j](numbers));
            CHECK(map.coordinate(j) == expected[j]);
        }
        const std::size_t f = random.below(shape.factors());
        const PolynomialPatch raised = elevate(patch, f, 2);
        CHECK(raised.shape()[f].degree == shape[f].degree + 2);
        for (std::size_t j = 0; j < patch.dimension(); ++j)
            CHECK(raised.coordinate(j) == patch.coordinate(j));
    }
}

TEST_CASE("control nets of polynomials over random simplices are the same maps, and go back") {
    Random random(822);
    for (const auto& dimensions : products_of_simplices()) {
        const PolynomialPatch patch = random_polynomial(random, dimensions);
        const NetShape& shape = patch.shape();
        const std::vector<BarycentricFrame> frames = random_frames(random, shape);
        const BezierPatch net = control_net(patch, frames);
        CHECK(monomial_form(net, frames) == patch);

        // With the barycentric coordinates y_k for x = sum of y_k v_k, the net is the homogeneous polynomial.
        const auto variables = barycentric_variables(shape);
        std::vector<SparsePolynomial> cartesian;
        for (std::size_t f = 0; f < shape.factors(); ++f) {
            for (std::size_t i = 0; i < shape[f].dimension; ++i) {
                SparsePolynomial& x = cartesian.emplace_back();
                for (std::size_t k = 0; k < variables[f].size(); ++k)
                    x += frames[f].vertices()[k][i] * variables[f][k];
            }
        }
        // On the affine space, where y_0 = 1 - y_1 - ... in every factor, the masses are 1.
        std::vector<SparsePolynomial> affine;
        for (const auto& own : variables) {
            SparsePolynomial rest = 1;
            for (std::size_t k = 1; k < own.size(); ++k) rest -= own[k];
            affine.push_back(rest);
            affine.insert(affine.end(), own.begin() + 1, own.end());
        }
        for (std::size_t j = 0; j < patch.dimension(); ++j) {
            CHECK(substitute(expanded(net, j), affine) ==
                  substitute(substitute(patch.coordinate(j), cartesian), affine));
        }
    }
}

TEST_CASE("the grouping of variables changes between simplex and tensor form") {
    const std::vector<SparsePolynomial> coordinates{polynomial_in_xy("x^2 + 3x*y - 2")};
    const PolynomialPatch triangle(NetShape::simplex(2, 2), coordinates);
    const std::vector<std::size_t> degrees{2, 1};
    const PolynomialPatch tensor = regrouped(triangle, NetShape::tensor(degrees));
    CHECK(tensor.coordinate(0) == coordinates[0]);
    CHECK(tensor.coefficients().to_points() == std::vector<Coordinates>{{-2}, {0}, {0}, {3}, {1}, {0}});
    CHECK(regrouped(tensor, NetShape::simplex(2, 2)) == triangle);
    const std::vector<std::size_t> low{1, 1};
    CHECK(failure_code([&] { regrouped(triangle, NetShape::tensor(low)); }) == ErrorCode::degree_too_low);
    CHECK(failure_code([&] { regrouped(triangle, NetShape::simplex(3, 2)); }) == ErrorCode::wrong_arity);
}

TEST_CASE("barycentric frames: coordinates of points and vectors, and what is no simplex") {
    Random random(823);
    for (std::size_t s = 0; s <= 4; ++s) {
        for (int round = 0; round < 10; ++round) {
            const BarycentricFrame frame = random_frame(random, s);
            const Coordinates expected = tuple(random, s, Size::any);
            const Rational mass = std::accumulate(expected.begin(), expected.end(), Rational());
            CHECK(frame.of_argument(frame.combination(expected), mass) == expected);
        }
    }
    const BarycentricFrame standard = BarycentricFrame::standard(2);
    CHECK(standard.of_point(Coordinates{Rational(1, 4), Rational(1, 2)}) ==
          Coordinates{Rational(1, 4), Rational(1, 4), Rational(1, 2)});
    CHECK(standard.of_vector(Coordinates{1, 1}) == Coordinates{-2, 1, 1});
    CHECK(failure_code([&] { standard.of_point(Coordinates{1}); }) == ErrorCode::mismatched_dimensions);
    CHECK(failure_code([&] { standard.combination(Coordinates{1}); }) == ErrorCode::mismatched_dimensions);

    // A triangle in space has coordinates only for the points of its plane.
    const BarycentricFrame plane({{0, 0, 1}, {2, 0, 1}, {0, 2, 3}});
    CHECK(plane.of_point(Coordinates{1, 1, 2}) == Coordinates{0, Rational(1, 2), Rational(1, 2)});
    CHECK(failure_code([&] { plane.of_point(Coordinates{1, 1, 1}); }) == ErrorCode::outside_domain);

    const auto error_of = [](std::vector<Coordinates> vertices) {
        return failure([&] { BarycentricFrame frame(std::move(vertices)); });
    };
    CHECK(error_of({{0, 0}, {1, 1}, {0, 1}, {2, 2}})->message() ==
          "the vertices 0, 1 and 3 are affinely dependent");
    CHECK(error_of({{0, 0}, {1, 1}, {0, 1}, {2, 2}})->place() == Part::vertices / 3);
    CHECK(error_of({{0, 0}, {1, 2}, {0, 0}})->message() == "the vertices 0 and 2 are the same point");
    CHECK(error_of({{0, 0}, {1, 2}, {0, 0}})->code() == ErrorCode::degenerate_simplex);
    CHECK(error_of({{0, 0}, {1}})->code() == ErrorCode::mismatched_dimensions);
    CHECK(error_of({})->code() == ErrorCode::wrong_arity);

    const std::vector<SparsePolynomial> coordinates{polynomial_in_xy("x + y")};
    const PolynomialPatch patch(NetShape::simplex(2, 1), coordinates);
    const std::vector<BarycentricFrame> line{BarycentricFrame::standard(1)};
    CHECK(failure_code([&] { control_net(patch, line); }) == ErrorCode::mismatched_dimensions);
    CHECK(failure_code([&] { control_net(patch, std::span(line).first(0)); }) == ErrorCode::wrong_arity);
}
