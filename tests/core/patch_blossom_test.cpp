#include <blossom/core/blossom/patch_blossom.hpp>
#include "core_test.hpp"

TEST_CASE("the products of simplices of total dimension up to 4") {
    CHECK(products_of_simplices().size() == 15);
}

TEST_CASE("patch blossom: the definition, over every product of simplices") {
    for_random_patches(801, 12, 100, [](Random& random, const PatchRecipe& recipe) {
        const PatchArguments arguments = patch_arguments(random, recipe.factors, Size::small);
        CHECK(blossom_value(recipe.patch(), arguments) == textbook_value(recipe, arguments));
    });
}

TEST_CASE("patch blossom: symmetric and linear in the arguments of each factor, the map on the diagonal") {
    for_random_patches(802, 6, 100, [](Random& random, const PatchRecipe& recipe) {
        const BezierPatch patch = recipe.patch();
        const PatchArguments arguments = patch_arguments(random, recipe.factors, Size::small);
        const Coordinates value = blossom_value(patch, arguments);
        for (std::size_t f = 0; f < recipe.factors.size(); ++f) {
            const std::size_t n = recipe.factors[f].degree;
            if (n == 0) continue;
            PatchArguments exchanged = arguments;
            std::swap(exchanged[f][random.below(n)], exchanged[f][random.below(n)]);
            CHECK(blossom_value(patch, exchanged) == value);

            const std::size_t i = random.below(n);
            PatchArguments first = arguments, second = arguments, both = arguments;
            first[f][i] = tuple(random, recipe.factors[f].dimension, Size::small);
            second[f][i] = tuple(random, recipe.factors[f].dimension, Size::small);
            const Rational a = number(random, Size::small), b = number(random, Size::small);
            both[f][i] = combined(a, first[f][i], b, second[f][i]);
            CHECK(blossom_value(patch, both) ==
                  combined(a, blossom_value(patch, first), b, blossom_value(patch, second)));
        }
        const PatchPoint point = patch_point(random, recipe.factors, Size::any);
        CHECK(blossom_value(patch, diagonal(patch.shape(), point)) == evaluate(patch, point));
    });
}

TEST_CASE("patch blossom: the control points are the values at the vertices") {
    for_random_patches(803, 2, 100, [](Random&, const PatchRecipe& recipe) {
        const BezierPatch patch = recipe.patch();
        for (const auto& [indices, expected] : recipe.points) {
            PatchArguments arguments;
            for (const MultiIndex& index : indices) {
                auto& list = arguments.emplace_back();
                for (std::size_t k = 0; k < index.size(); ++k) {
                    Coordinates vertex(index.size());
                    vertex[k] = 1;
                    list.insert(list.end(), index[k], vertex);
                }
            }
            CHECK(blossom_value(patch, arguments) == expected);
        }
    });
}

TEST_CASE("patch evaluation: the Bernstein polynomials, at several points at once") {
    for_random_patches(804, 4, 100, [](Random& random, const PatchRecipe& recipe) {
        const BezierPatch patch = recipe.patch();
        std::vector<PatchPoint> points;
        for (int i = 0; i < 3; ++i) points.push_back(patch_point(random, recipe.factors, Size::any));
        const std::vector<Coordinates> values = evaluate(patch, points);
        for (std::size_t i = 0; i < points.size(); ++i) {
            std::vector<Rational> numbers;
            for (const Coordinates& own : points[i]) numbers.insert(numbers.end(), own.begin(), own.end());
            for (std::size_t j = 0; j < patch.dimension(); ++j)
                CHECK(values[i][j] == expanded(patch, j)(numbers));
        }
    });
}

TEST_CASE("patch arguments: what does not fit the shape is refused with its place") {
    const std::vector<Coordinates> net(6, Coordinates{1});
    const BezierPatch triangle(NetShape::simplex(2, 2), net);
    const Coordinates point{1, 0, 0};
    const auto error_of = [&](const PatchArguments& arguments) {
        return failure([&] { blossom_value(triangle, arguments); });
    };
    CHECK(error_of({})->place() == Part::arguments);
    CHECK(error_of({})->code() == ErrorCode::wrong_arity);
    CHECK(error_of({{point}})->place() == Part::arguments / 0);
    CHECK(error_of({{point}})->code() == ErrorCode::wrong_arity);
    CHECK(error_of({{point, {1, 0}}})->place() == Part::arguments / 0 / 1);
    CHECK(error_of({{point, {1, 0}}})->code() == ErrorCode::mismatched_dimensions);
    CHECK(error_of({{point, point}}) == std::nullopt);

    CHECK(failure_code([&] { evaluate(triangle, PatchPoint{{1, 1, 0}}); }) == ErrorCode::not_affine);
    CHECK(failure([&] { evaluate(triangle, PatchPoint{{1, 1, 0}}); })->place() == Part::at / 0 / 0);
    CHECK(failure_code([&] { evaluate(triangle, PatchPoint{{1, 0}}); }) == ErrorCode::mismatched_dimensions);
    CHECK(failure_code([&] { BezierPatch(NetShape::simplex(2, 2), std::span(net).first(5)); }) ==
          ErrorCode::incomplete_net);
    CHECK(failure_code([&] { derivative(triangle, {{point}}, PatchPoint{point}); }) == ErrorCode::not_affine);
    CHECK(failure_code([&] { derivative_patch(triangle, {{point}}); }) == ErrorCode::not_affine);
}

TEST_CASE("patch limits: too many points or digits are refused") {
    CHECK(failure_code([] { NetShape::simplex(8, 100); }) == ErrorCode::limit_exceeded);
    CHECK(failure_code([] { NetShape::simplex(std::size_t{1} << 62, 2); }) == ErrorCode::limit_exceeded);
    CHECK(failure_code([] { NetShape::simplex(1, 10'001); }) == ErrorCode::limit_exceeded);
    const std::vector<std::size_t> degrees(30, 1);
    CHECK(failure_code([&] { NetShape::tensor(degrees); }) == ErrorCode::limit_exceeded);
    Limits limits;
    limits.digits = 20;
    const BezierPatch line(NetShape::simplex(1, 4), std::vector<Coordinates>(5, Coordinates{3}));
    const Rational big = pow(Rational(10), 6);
    const PatchPoint far{{Rational(1) - big, big}};
    CHECK(failure_code([&] { blossom_value(line, diagonal(line.shape(), far), limits); }) ==
          ErrorCode::limit_exceeded);
    CHECK(failure_code([&] { evaluate(line, far, limits); }) == ErrorCode::limit_exceeded);
    CHECK(evaluate(line, far) == Coordinates{3});
}
