#include <blossom/core/blossom/agreement.hpp>
#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/blossom/patch_subdivision.hpp>
#include <blossom/core/patch/patch_contact.hpp>
#include "core_test.hpp"

// The three constructions over products of simplices, the inverse formula, and contact along faces.

namespace {

constexpr Construction constructions_by_name[] = {Construction::symmetric, Construction::polarization,
                                                  Construction::casteljau};

/// sum c_i x^i at tuples (mass, x) by the definition: the average over all orders of the assignments. It is
/// the value of the control net c_i / multinomial(i) over the frame of origin and unit vectors.
Coordinates definition(const PatchRecipe& recipe, const PatchArguments& arguments) {
    PatchRecipe polar = recipe;
    for (auto& [indices, point] : polar.points) {
        for (const MultiIndex& index : indices) {
            std::size_t total = 0;
            for (const std::size_t entry : index) {
                for (std::size_t i = 1; i <= entry; ++i) {
                    const Rational quotient(i, ++total);
                    for (Rational& coordinate : point) coordinate *= quotient;
                }
            }
        }
    }
    return textbook_value(polar, arguments);
}

std::vector<BarycentricFrame> standard_frames(const NetShape& shape) {
    std::vector<BarycentricFrame> frames;
    for (std::size_t f = 0; f < shape.factors(); ++f)
        frames.push_back(BarycentricFrame::standard(shape[f].dimension));
    return frames;
}

}  // namespace

TEST_CASE("patch constructions: each gives the definition, for nets and for polynomials") {
    for_random_patches(831, 3, 40, [](Random& random, const PatchRecipe& recipe) {
        const BezierPatch net = recipe.patch();
        const PolynomialPatch polynomial(net.shape(), net.control_net());
        const PatchArguments arguments = patch_arguments(random, recipe.factors, Size::small);
        for (const Construction construction : constructions_by_name) {
            CHECK(blossom_value(PatchMap(net), arguments, construction) == textbook_value(recipe, arguments));
            CHECK(blossom_value(PatchMap(polynomial), arguments, construction) ==
                  definition(recipe, arguments));
        }
        CHECK(agreement(net, arguments).agree());
        CHECK(agreement(polynomial, arguments).results.size() == 3);
    });
}

TEST_CASE("patch constructions: they agree for all arguments, and the expansion is the blossom") {
    Random random(832);
    for (const auto& dimensions : products_of_simplices()) {
        const PatchRecipe recipe = patch(random, dimensions, Size::small, 15);
        const BezierPatch net = recipe.patch();
        const PolynomialPatch polynomial(net.shape(), net.control_net());
        // Only points, because the symbols denote points.
        PatchArguments points, affine;
        std::vector<Rational> numbers;
        for (const auto& [dimension, degree] : recipe.factors) {
            auto& own = points.emplace_back();
            auto& with_mass = affine.emplace_back();
            for (std::size_t i = 0; i < degree; ++i) {
                own.push_back(tuple_of_mass(random, dimension, 1, Size::small));
                numbers.insert(numbers.end(), own.back().begin() + 1, own.back().end());
                with_mass.push_back(own.back());
                with_mass.back()[0] = 1;
            }
        }
        const auto of_net = agreement_for_all_arguments(PatchMap(net));
        const auto of_polynomial = agreement_for_all_arguments(PatchMap(polynomial));
        REQUIRE(of_net.agree());
        REQUIRE(of_polynomial.agree());
        for (const auto* proof : {&of_net, &of_polynomial}) {
            for (const auto& result : proof->results) CHECK(result.skipped.empty());
        }
        const Coordinates net_value = textbook_value(recipe, points);
        const Coordinates polynomial_value = definition(recipe, affine);
        for (std::size_t j = 0; j < recipe.dimension(); ++j) {
            CHECK((*of_net.results[0].value)[j](numbers) == net_value[j]);
            CHECK((*of_polynomial.results[0].value)[j](numbers) == polynomial_value[j]);
        }
    }
}

TEST_CASE("patch constructions: what is too large is skipped with its reason or refused") {
    const BezierPatch triangle(NetShape::simplex(2, 4), std::vector<Coordinates>(15, Coordinates{1}));
    PatchArguments arguments{{}};
    for (int i = 0; i < 4; ++i) arguments[0].push_back({1 - i, i, 0});
    Limits limits;
    limits.polarization_terms = 15;
    const auto values = agreement(PatchMap(triangle), arguments, limits);
    CHECK(values.results[1].skipped == "more terms than the limit polarization_terms = 15");
    CHECK(values.agree());
    CHECK(failure_code([&] {
              blossom_value(PatchMap(triangle), arguments, Construction::polarization, limits);
          }) == ErrorCode::limit_exceeded);
    limits.expansion_terms = 80;
    CHECK(failure_code([&] { agreement_for_all_arguments(PatchMap(triangle), limits); }) ==
          ErrorCode::limit_exceeded);
    limits.expansion_terms = 81;
    limits.expansion_work = 10;
    const auto proof = agreement_for_all_arguments(PatchMap(triangle), limits);
    CHECK(proof.results[1].skipped.starts_with("1816 "));
    CHECK(proof.agree());
}

TEST_CASE("patch inverse formula: the net and the blossom from values alone") {
    for_random_patches(833, 2, 40, [](Random& random, const PatchRecipe& recipe) {
        const BezierPatch net = recipe.patch();
        const auto values = [&](const PatchPoint& point) {
            return textbook_value(recipe, diagonal(net.shape(), point));
        };
        CHECK(control_net_from_values(net.shape(), values) == net);
        PatchArguments points;
        for (const auto& [dimension, degree] : recipe.factors) {
            auto& own = points.emplace_back();
            for (std::size_t i = 0; i < degree; ++i) {
                own.push_back(i % 3 == 2 ? own[0] : tuple_of_mass(random, dimension, 1, Size::small));
            }
        }
        CHECK(blossom_from_values(net.shape(), values, points) == textbook_value(recipe, points));
    });
    const NetShape triangle = NetShape::simplex(2, 1);
    const auto one = [](const PatchPoint&) { return Coordinates{1}; };
    CHECK(failure_code([&] { blossom_from_values(triangle, one, {{{1, 1, 0}}}); }) == ErrorCode::not_affine);
    CHECK(failure_code([&] { blossom_from_values(triangle, one, {{}}); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([&] { inverse_formula({2, 400}); }) == ErrorCode::limit_exceeded);
    const auto ragged = [](const PatchPoint& point) { return Coordinates(point[0][0] == 1 ? 1 : 2); };
    CHECK(failure_code([&] { control_net_from_values(triangle, ragged); }) ==
          ErrorCode::mismatched_dimensions);
}

TEST_CASE("patch contact: the pieces of a subdivision are one map, and a changed point lowers the order") {
    Random random(834);
    for (const auto& dimensions : products_of_simplices()) {
        const BezierPatch whole = patch(random, dimensions, Size::small, 40).patch();
        const NetShape& shape = whole.shape();
        const std::size_t f = random.below(shape.factors());
        const std::size_t s = shape[f].dimension;
        const Coordinates middle(s + 1, Rational(1, s + 1));
        const std::vector<BezierPatch> pieces = subdivide(whole, f, middle);
        std::vector<BarycentricFrame> frames = standard_frames(shape);
        std::vector<PlacedPatch> placed;
        for (std::size_t k : {std::size_t{0}, s}) {
            std::vector<Coordinates> vertices = frames[f].vertices();
            vertices[k] = frames[f].combination(middle);
            std::vector<BarycentricFrame> own = frames;
            own[f] = BarycentricFrame(vertices);
            placed.push_back({pieces[k], own});
        }
        // In the left piece the midpoint replaces vertex 0, in the right one vertex s: the pieces share all
        // vertices of the left one except vertex s.
        const Face face = shared_face(placed[0].frames, placed[1].frames).face;
        CHECK(face[f].size() == s);
        CHECK(face[f].back() == s - 1);
        placed[1].patch = elevate(placed[1].patch, f, 1);
        CHECK(contact(placed[0], placed[1], face).is_infinite());

        // Changes a control point of the left piece with k of its vertices off the face.
        std::vector<Coordinates> net = pieces[0].control_net().to_points();
        const std::size_t place = random.below(net.size());
        net[place][0] += 1;
        const PlacedPatch changed{BezierPatch(shape, net), placed[0].frames};
        const auto own_index = multi_indices(s, shape[f].degree)[place / shape.behind(f) % shape.count(f)];
        placed[1].patch = pieces[s];
        const PatchContact result = contact(changed, placed[1], face);
        REQUIRE_FALSE(result.is_infinite());
        CHECK(*result.order == static_cast<std::ptrdiff_t>(own_index[s]) - 1);
        CHECK(result.first_difference->left[0] == result.first_difference->right[0] + 1);
        CHECK(result.first_difference->arguments.size() == shape.factors());
    }
}

TEST_CASE("patch contact: by derivatives across the common edge of two triangles") {
    // f = x^2 + y over (0,0), (1,0), (0,1) and g = f + (x + y - 1)^2 over (1,1), (1,0), (0,1): order 1.
    const std::vector<BarycentricFrame> lower{BarycentricFrame({{0, 0}, {1, 0}, {0, 1}})};
    const std::vector<BarycentricFrame> upper{BarycentricFrame({{1, 1}, {1, 0}, {0, 1}})};
    const auto net_of = [](const BarycentricFrame& frame, const auto& function) {
        const auto values = [&](const PatchPoint& point) {
            const Coordinates xy = frame.combination(point[0]);
            return Coordinates{function(xy[0], xy[1])};
        };
        return control_net_from_values(NetShape::simplex(2, 2), values);
    };
    const auto f = [](const Rational& x, const Rational& y) { return x * x + y; };
    const auto g = [&](const Rational& x, const Rational& y) { return f(x, y) + (x + y - 1) * (x + y - 1); };
    const PlacedPatch left{net_of(lower[0], f), lower};
    const Face face = shared_face(lower, upper).face;
    CHECK(face == Face{{1, 2}});
    const PatchContact result = contact(left, {net_of(upper[0], g), upper}, face);
    CHECK(result.order == 1);
    CHECK(to_string(result) ==
          "The patches meet with order 1 along the face: the blossom values at [(0, 0), (0, 0)] are 0 and 1");
    CHECK(contact(left, {net_of(upper[0], f), upper}, face).is_infinite());
    const auto h = [&](const Rational& x, const Rational& y) { return f(x, y) + y; };
    CHECK(contact(left, {net_of(upper[0], h), upper}, face).order == -1);
    CHECK(
        to_string(contact(left, {net_of(upper[0], h), upper}, face)).starts_with("The patches do not meet"));
    CHECK(to_string(contact(left, left, face)) == "The patches are the same polynomial");

    CHECK(failure_code([&] { shared_face(lower, {}); }) == ErrorCode::mismatched_dimensions);
    const std::vector<BarycentricFrame> away{BarycentricFrame({{5, 5}, {6, 5}, {5, 6}})};
    CHECK(failure_code([&] { shared_face(lower, away); }) == ErrorCode::not_adjacent);
    const PlacedPatch planar{BezierPatch(NetShape::simplex(2, 0), std::vector<Coordinates>{{1, 2}}), lower};
    CHECK(failure_code([&] { contact(left, planar, face); }) == ErrorCode::mismatched_dimensions);
    CHECK(failure_code([&] { contact(left, left, {}); }) == ErrorCode::wrong_arity);
}
