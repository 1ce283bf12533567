#include "map_generators.hpp"

#include "number_generators.hpp"

namespace blossom::testing {

namespace {

Coordinates coordinates(Random& random, std::size_t dimension, Size size) {
    Coordinates point;
    for (std::size_t j = 0; j < dimension; ++j)
        point.push_back(random.one_in(4) ? Rational() : number(random, size));
    return point;
}

std::size_t dimension(Random& random) { return 1 + random.below(3); }

template <class Item, class Make>
std::vector<Item> with_repetitions(Random& random, std::size_t n, const Make& make) {
    std::vector<Item> items;
    while (items.size() < n) {
        const bool repeat = !items.empty() && random.one_in(3);
        items.push_back(repeat ? Item(items[random.below(items.size())]) : make());
    }
    return items;
}

}  // namespace

Rational number(Random& random, Size size) {
    return size == Size::small ? small_rational(random) : rational(random);
}

PolynomialRecipe polynomial_map(Random& random, std::size_t degree, Size size) {
    const std::size_t d = dimension(random);
    const std::size_t given = random.one_in(3) ? random.below(degree + 1) : degree;
    PolynomialRecipe recipe{{}, degree};
    for (std::size_t k = 0; k <= given; ++k) recipe.coefficients.push_back(coordinates(random, d, size));
    return recipe;
}

BezierRecipe bezier_map(Random& random, std::size_t degree, Size size) {
    const std::size_t d = dimension(random);
    std::vector<Coordinates> control_points;
    for (std::size_t k = 0; k <= degree; ++k) control_points.push_back(coordinates(random, d, size));
    return {std::move(control_points), interval(random, size)};
}

PolynomialMap any_map(Random& random, std::size_t degree, Size size) {
    if (random.one_in(2)) return polynomial_map(random, degree, size).curve();
    return bezier_map(random, degree, size).curve();
}

Interval interval(Random& random, Size size) {
    if (random.one_in(4)) return {};
    if (random.one_in(6)) return {1, 0};
    const Rational a = number(random, size);
    Rational b = number(random, size);
    while (a == b) b = number(random, size);
    return {a, b};
}

Polynomial polynomial(Random& random, std::size_t degree, Size size) {
    std::vector<Rational> coefficients;
    for (std::uint64_t k = random.below(degree + 2); k > 0; --k) {
        coefficients.push_back(random.one_in(4) ? Rational() : number(random, size));
    }
    return Polynomial(coefficients);
}

Parameter point(Random& random, Size size) {
    if (random.one_in(6)) return random.between(0, 1);
    return number(random, size);
}

Argument argument(Random& random, Size size) {
    const std::uint64_t share = random.below(8);
    if (share < 4) return point(random, size);
    if (share < 6) return random.one_in(3) ? delta : Direction{number(random, size)};
    Rational u = number(random, size);
    return {std::move(u), number(random, size)};
}

std::vector<Argument> arguments(Random& random, std::size_t n, Size size) {
    return with_repetitions<Argument>(random, n, [&] { return argument(random, size); });
}

std::vector<Parameter> points(Random& random, std::size_t n, Size size) {
    return with_repetitions<Parameter>(random, n, [&] { return point(random, size); });
}

Coordinates combined(const Rational& a, const Coordinates& x, const Rational& b, const Coordinates& y) {
    Coordinates result;
    for (std::size_t j = 0; j < x.size(); ++j) result.push_back(a * x[j] + b * y[j]);
    return result;
}

}  // namespace blossom::testing
