#include "core_test.hpp"

// The axioms that define a blossom, for every construction, on polynomials and on control polygons over any
// interval.

namespace {

constexpr int cases = 700;

/// A map of either kind of degree 0 to 6, and its value by the definition.
struct Sample {
    PolynomialMap map;
    std::vector<std::string> value_at_t;
};

Sample sample(Random& random, std::size_t degree, const Rational& t) {
    const Size size = random.one_in(4) ? Size::any : Size::small;
    if (random.one_in(2)) {
        const PolynomialRecipe recipe = polynomial_map(random, degree, size);
        return {recipe.curve(), textbook::polynomial_value(recipe.coefficients, t)};
    }
    const BezierRecipe recipe = bezier_map(random, degree, size);
    return {recipe.curve(), textbook::bernstein_value(recipe.control_points, recipe.interval, t)};
}

std::vector<Argument> with(std::vector<Argument> arguments, std::size_t slot, const Argument& argument) {
    arguments[slot] = argument;
    return arguments;
}

void shuffle(std::vector<Argument>& arguments, Random& random) {
    for (std::size_t i = arguments.size(); i > 1; --i)
        std::swap(arguments[i - 1], arguments[random.below(i)]);
}

}  // namespace

TEST_CASE("every construction is symmetric", "[blossom][axioms]") {
    Random random(201);
    for (const auto& [name, construct] : every_construction()) {
        for (int i = 0; i < cases; ++i) {
            const std::size_t n = random.below(7);
            const PolynomialMap map = sample(random, n, 0).map;
            std::vector<Argument> list = arguments(random, n, Size::small);
            const Coordinates value = construct(map, list);
            shuffle(list, random);
            CAPTURE(name, list);
            CHECK(construct(map, list) == value);
        }
    }
}

TEST_CASE("every construction gives the map on the diagonal", "[blossom][axioms]") {
    Random random(203);
    for (const auto& [name, construct] : every_construction()) {
        for (int i = 0; i < cases; ++i) {
            const std::size_t n = random.below(7);
            const Rational t = number(random, random.one_in(4) ? Size::any : Size::small);
            const Sample chosen = sample(random, n, t);
            CAPTURE(name, n, t);
            CHECK(textbook::text(construct(chosen.map, with_copies({}, n, Parameter(t)))) ==
                  chosen.value_at_t);
        }
    }
}

TEST_CASE("every construction is linear in each pair, and vanishes at the zero pair", "[blossom][axioms]") {
    Random random(204);
    for (const auto& [name, construct] : every_construction()) {
        for (int i = 0; i < cases; ++i) {
            const std::size_t n = 1 + random.below(6);
            const PolynomialMap map = sample(random, n, 0).map;
            const std::vector<Argument> list = arguments(random, n, Size::small);
            const std::size_t slot = random.below(n);
            const Argument x = argument(random, Size::any);
            const Argument y = argument(random, Size::small);
            const Rational a = number(random, Size::small);
            const Rational b = number(random, Size::small);
            CAPTURE(name, list, slot, x, y, a, b);
            const Argument both(a * x.u + b * y.u, a * x.mass + b * y.mass);
            CHECK(construct(map, with(list, slot, both)) ==
                  combined(a, construct(map, with(list, slot, x)), b, construct(map, with(list, slot, y))));
            const Coordinates zero = construct(map, with(list, slot, Argument(0, 0)));
            CHECK(zero == Coordinates(zero.size()));
        }
    }
}
