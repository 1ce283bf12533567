#include <blossom/core/algebra/sparse_algebra.hpp>
#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/blossom/patch_subdivision.hpp>
#include <blossom/core/maps/barycentric_frame.hpp>
#include "core_test.hpp"

// Subdivision, other frames, derivatives and degree raising, each compared with the expanded polynomial.

namespace {

/// The variables, where those of one factor are replaced by the combinations sum_k y_k elements[k].
std::vector<SparsePolynomial> in_frame(const NetShape& shape, std::size_t factor,
                                       const std::vector<Coordinates>& elements) {
    std::vector<SparsePolynomial> values;
    const auto variables = barycentric_variables(shape);
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        for (std::size_t i = 0; i < variables[f].size(); ++i) {
            SparsePolynomial value = f == factor ? SparsePolynomial() : variables[f][i];
            for (std::size_t k = 0; f == factor && k < elements.size(); ++k)
                value += elements[k][i] * variables[f][k];
            values.push_back(std::move(value));
        }
    }
    return values;
}

/// Checks that `piece` is the map of `patch` over the elements.
void check_frame(const BezierPatch& patch, const BezierPatch& piece, std::size_t factor,
                 const std::vector<Coordinates>& elements) {
    REQUIRE(piece.shape() == patch.shape());
    const auto values = in_frame(patch.shape(), factor, elements);
    for (std::size_t j = 0; j < patch.dimension(); ++j) {
        CHECK(expanded(piece, j) == substitute(expanded(patch, j), values));
    }
}

Coordinates unit(std::size_t size, std::size_t k) {
    Coordinates vertex(size);
    vertex[k] = 1;
    return vertex;
}

std::vector<Coordinates> vertices(std::size_t dimension) {
    std::vector<Coordinates> all;
    for (std::size_t k = 0; k <= dimension; ++k) all.push_back(unit(dimension + 1, k));
    return all;
}

/// Barycentric coordinates without the first: points of Q^s.
std::vector<Coordinates> corners(const std::vector<Coordinates>& simplex) {
    std::vector<Coordinates> points;
    for (const Coordinates& vertex : simplex) points.emplace_back(vertex.begin() + 1, vertex.end());
    return points;
}

/// The determinant of the edges from the first vertex, by expansion along the first row.
Rational determinant(const std::vector<Coordinates>& rows) {
    if (rows.empty()) return 1;
    Rational sum;
    for (std::size_t j = 0; j < rows.size(); ++j) {
        std::vector<Coordinates> minor(rows.begin() + 1, rows.end());
        for (Coordinates& row : minor) row.erase(row.begin() + static_cast<std::ptrdiff_t>(j));
        sum += Rational(j % 2 == 0 ? 1 : -1) * rows[0][j] * determinant(minor);
    }
    return sum;
}

Rational volume(const std::vector<Coordinates>& vertices) {
    std::vector<Coordinates> edges;
    for (std::size_t k = 1; k < vertices.size(); ++k) {
        Coordinates& edge = edges.emplace_back();
        for (std::size_t j = 0; j < vertices[k].size(); ++j) edge.push_back(vertices[k][j] - vertices[0][j]);
    }
    return determinant(edges);
}

}  // namespace

TEST_CASE("patch subdivision: the pieces at a point reproduce the map") {
    for_random_patches(811, 3, 40, [](Random& random, const PatchRecipe& recipe) {
        const BezierPatch patch = recipe.patch();
        const std::size_t f = random.below(patch.shape().factors());
        const std::size_t s = patch.shape()[f].dimension;
        Coordinates point = tuple_of_mass(random, s, 1, Size::small);
        while (std::ranges::find(point, Rational()) != point.end())
            point = tuple_of_mass(random, s, 1, Size::small);
        const std::vector<BezierPatch> pieces = subdivide(patch, f, point);
        REQUIRE(pieces.size() == s + 1);
        for (std::size_t k = 0; k <= s; ++k) {
            std::vector<Coordinates> elements = vertices(s);
            elements[k] = point;
            check_frame(patch, pieces[k], f, elements);
        }
    });
    const BezierPatch patch(NetShape::simplex(2, 1), std::vector<Coordinates>(3, Coordinates{1}));
    const Rational half(1, 2);
    const auto error = failure([&] { subdivide(patch, 0, {0, 1, 0}); });
    CHECK(error->code() == ErrorCode::degenerate_simplex);
    CHECK(error->message().find("the point is vertex 1") != std::string::npos);
    CHECK(replaced_vertices({half, 0, half}) == std::vector<std::size_t>{0, 2});
    CHECK(subdivide(patch, 0, {half, 0, half}).size() == 2);
    CHECK(failure_code([&] { subdivide(patch, 0, {half, half, half}); }) == ErrorCode::not_affine);
    CHECK(failure_code([&] { subdivide(patch, 0, {half, half}); }) == ErrorCode::mismatched_dimensions);
}

TEST_CASE(
    "patch subdivision: the pieces at the midpoints of the edges reproduce the map and fill the simplex") {
    for_random_patches(812, 1, 40, [](Random& random, const PatchRecipe& recipe) {
        const BezierPatch patch = recipe.patch();
        const std::size_t f = random.below(patch.shape().factors());
        const auto pieces = subdivide_at_midpoints(patch, f);
        REQUIRE(pieces.size() == std::size_t{1} << patch.shape()[f].dimension);
        for (const auto& [piece, elements] : pieces) check_frame(patch, piece, f, elements);
    });
    // The triangles: three at the corners and the one between the midpoints.
    const Rational half(1, 2);
    const Coordinates m01{half, half, 0}, m02{half, 0, half}, m12{0, half, half};
    CHECK(midpoint_simplices(2) ==
          std::vector<std::vector<Coordinates>>{
              {unit(3, 0), m01, m02}, {m01, unit(3, 1), m12}, {m01, m02, m12}, {m02, m12, unit(3, 2)}});
    // Each has volume 2^-s, and the centre of each has positive coordinates over no other.
    for (std::size_t s = 1; s <= 4; ++s) {
        const auto simplices = midpoint_simplices(s);
        for (const auto& simplex : simplices) {
            const BarycentricFrame own(corners(simplex));
            const Rational share(1, s + 1);
            const Coordinates center = own.combination(Coordinates(s + 1, share));
            for (const auto& other : simplices) {
                const Coordinates over = BarycentricFrame(corners(other)).of_point(center);
                const bool inside = std::ranges::all_of(over, [](const Rational& x) { return x.sign() > 0; });
                CHECK(inside == (simplex == other));
            }
            CHECK(abs(volume(corners(simplex))) == Rational(1, pow(Integer(2), s)));
        }
    }
}

TEST_CASE("patch frames: the net over any elements, points, vectors or others") {
    for_random_patches(813, 4, 40, [](Random& random, const PatchRecipe& recipe) {
        const BezierPatch patch = recipe.patch();
        const std::size_t f = random.below(patch.shape().factors());
        const std::size_t s = patch.shape()[f].dimension;
        std::vector<Coordinates> elements;
        for (std::size_t k = 0; k <= s; ++k) elements.push_back(tuple(random, s, Size::small));
        try {
            const BezierPatch over = with_frame(patch, f, elements);
            check_frame(patch, over, f, elements);
        } catch (const Error& error) {
            CHECK(error.code() == ErrorCode::degenerate_simplex);
        }
        // Permutations of the vertices.
        std::vector<Coordinates> reversed = vertices(s);
        std::ranges::reverse(reversed);
        check_frame(patch, with_frame(patch, f, reversed), f, reversed);
        std::ranges::rotate(reversed, reversed.begin() + 1);
        check_frame(patch, with_frame(patch, f, reversed), f, reversed);
    });
}

TEST_CASE("patch frames: dependent elements are named") {
    const BezierPatch patch(NetShape::simplex(2, 2), std::vector<Coordinates>(6, Coordinates{1}));
    const Coordinates a{1, 0, 0}, b{0, 1, 0}, middle{Rational(1, 2), Rational(1, 2), 0};
    const auto error_of = [&](const std::vector<Coordinates>& elements) {
        return failure([&] { with_frame(patch, 0, elements); });
    };
    CHECK(error_of({a, b, middle})->code() == ErrorCode::degenerate_simplex);
    CHECK(error_of({a, b, middle})->message() ==
          "the elements 0, 1 and 2 of the frame are linearly dependent");
    CHECK(error_of({middle, a, b})->place() == Part::elements / 2);
    CHECK(error_of({a, b, b})->message() == "the elements 1 and 2 of the frame are linearly dependent");
    CHECK(error_of({a, Coordinates(3), b})->message() == "element 1 of the frame is zero");
    CHECK(error_of({a, b})->code() == ErrorCode::wrong_arity);
    CHECK(error_of({a, b, {1, 2}})->code() == ErrorCode::mismatched_dimensions);
}

TEST_CASE("patch derivatives: nets and values are those of the expanded polynomial") {
    for_random_patches(814, 3, 40, [](Random& random, const PatchRecipe& recipe) {
        const BezierPatch patch = recipe.patch();
        const NetShape& shape = patch.shape();
        const auto variables = barycentric_variables(shape);
        PatchArguments directions;
        std::vector<SparsePolynomial> expected;
        for (std::size_t j = 0; j < patch.dimension(); ++j) expected.push_back(expanded(patch, j));
        for (std::size_t f = 0, first = 0; f < shape.factors(); first += variables[f++].size()) {
            auto& list = directions.emplace_back();
            for (std::uint64_t k = random.below(3); k > 0; --k) {
                list.push_back(tuple_of_mass(random, shape[f].dimension, 0, Size::small));
                for (SparsePolynomial& polynomial : expected) {
                    SparsePolynomial sum;
                    for (std::size_t i = 0; i < variables[f].size(); ++i) {
                        sum += list.back()[i] * derivative(polynomial, first + i);
                    }
                    polynomial = sum;
                }
            }
        }
        const BezierPatch net = derivative_patch(patch, directions);
        PatchPoint point;
        std::vector<Rational> numbers;
        for (std::size_t f = 0; f < shape.factors(); ++f) {
            point.push_back(tuple_of_mass(random, shape[f].dimension, 1, Size::small));
            numbers.insert(numbers.end(), point.back().begin(), point.back().end());
            CHECK(net.shape()[f].degree + std::min(directions[f].size(), shape[f].degree) == shape[f].degree);
        }
        const Coordinates value = derivative(patch, directions, point);
        for (std::size_t j = 0; j < patch.dimension(); ++j) {
            CHECK(expanded(net, j) == expected[j]);
            CHECK(value[j] == expected[j](numbers));
        }
    });
}

TEST_CASE("patch elevation: the expanded polynomial times a power of the sum of the coordinates") {
    for_random_patches(815, 3, 40, [](Random& random, const PatchRecipe& recipe) {
        const BezierPatch patch = recipe.patch();
        const std::size_t f = random.below(patch.shape().factors());
        const std::size_t r = random.below(3);
        const BezierPatch raised = elevate(patch, f, r);
        CHECK(raised.shape() == patch.shape().with_degree(f, patch.shape()[f].degree + r));
        const SparsePolynomial one = sum(barycentric_variables(patch.shape())[f]);
        for (std::size_t j = 0; j < patch.dimension(); ++j)
            CHECK(expanded(raised, j) == expanded(patch, j) * pow(one, r));
        std::vector<std::size_t> degrees;
        for (std::size_t k = 0; k < patch.shape().factors(); ++k) degrees.push_back(raised.shape()[k].degree);
        CHECK(elevated_to(patch, degrees) == raised);
        if (r > 0) {
            --degrees[f];
            degrees[f] = degrees[f] >= r ? degrees[f] - r : degrees[f];
        }
        if (degrees[f] < patch.shape()[f].degree) {
            CHECK(failure_code([&] { elevated_to(patch, degrees); }) == ErrorCode::degree_too_low);
        }
    });
    const BezierPatch patch(NetShape::simplex(2, 1), std::vector<Coordinates>(3, Coordinates{1}));
    CHECK(failure_code([&] { elevate(patch, 0, 10'000); }) == ErrorCode::limit_exceeded);
    CHECK(failure_code([&] { elevate(patch, 0, SIZE_MAX); }) == ErrorCode::limit_exceeded);
    CHECK(failure_code([&] { elevate(patch, 0, 5'000); }) == ErrorCode::limit_exceeded);
}
