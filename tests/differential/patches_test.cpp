// Nets of patches in words, in limbs, modulo primes and in integers, compared with the constructions over
// rational numbers, with numbers near the limits of words.

#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/blossom/patch_subdivision.hpp>
#include <blossom/core/blossom/patch_values.hpp>
#include <blossom/core/constructions/net_constructions.hpp>
#include <blossom/core/curve/degree_elevation.hpp>

#include <numeric>

#include "each_case.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

/// One to three factors of dimension 0 to 3, most of them segments and triangles, with at most 200 points.
NetShape shape(Random& random) {
    for (;;) {
        std::vector<SimplexFactor> factors;
        std::size_t points = 1;
        for (std::size_t f = 1 + random.below(3); f > 0; --f) {
            const std::size_t dimension = random.one_in(4) ? random.below(4) : 1 + random.below(2);
            factors.push_back({dimension, random.below(random.one_in(4) ? 15 : 5)});
            points *= multi_index_count(dimension, factors.back().degree);
        }
        if (points <= 200) return NetShape(factors);
    }
}

std::size_t total_degree(const NetShape& shape) {
    std::size_t degree = 0;
    for (const SimplexFactor& factor : shape.list()) degree += factor.degree;
    return degree;
}

/// The bits of arguments and of the numbers of a net for which values are near the limits of words, or long.
struct Sizes {
    std::size_t argument;
    std::size_t net;
};
Sizes sizes(Random& random, const NetShape& shape) {
    const std::size_t limits[] = {63, 127, 300, 1000};
    const std::size_t limit = limits[random.below(4)];
    const std::size_t degree = total_degree(shape);
    const std::size_t argument = 1 + random.below(std::min<std::size_t>(limit / (degree + 1) + 1, 70));
    return {argument, limit + 3 - std::min(limit + 2, degree * argument + random.below(8))};
}

std::vector<std::vector<Rational>> rows(Random& random, const NetShape& shape, std::size_t bits) {
    const Integer denominator = random.one_in(2) ? Integer(1) : abs(number_near(random, 20)) + 1;
    std::vector<std::vector<Rational>> rows(1 + random.below(3));
    for (auto& row : rows) {
        for (std::size_t i = 0; i < shape.size(); ++i)
            row.emplace_back(number_near(random, bits), denominator);
    }
    return rows;
}

/// The numbers of a net, and the bits of arguments that go with them.
struct RandomNet {
    NetShape shape;
    std::size_t argument_bits;
    std::vector<std::vector<Rational>> rows;
};
RandomNet random_net(Random& random) {
    NetShape net_shape = shape(random);
    const auto [argument_bits, net_bits] = sizes(random, net_shape);
    auto numbers = rows(random, net_shape, net_bits);
    return {std::move(net_shape), argument_bits, std::move(numbers)};
}

PointArray points(const std::vector<std::vector<Rational>>& rows) {
    std::vector<Rational> numbers;
    for (const auto& row : rows) numbers.insert(numbers.end(), row.begin(), row.end());
    return {rows.size(), RationalVector(numbers)};
}

/// A tuple with entries over one denominator or over several; sometimes a vertex.
Coordinates tuple(Random& random, std::size_t dimension, std::size_t bits) {
    Coordinates tuple(dimension + 1);
    if (random.one_in(8)) {
        tuple[random.below(tuple.size())] = 1;
        return tuple;
    }
    Integer denominator = abs(number_near(random, bits)) + 1;
    for (Rational& entry : tuple) {
        if (random.one_in(6)) denominator = abs(number_near(random, bits)) + 1;
        entry = Rational(number_near(random, bits), denominator);
    }
    return tuple;
}

Coordinates of_mass_one(Coordinates tuple) {
    tuple.back() += 1 - std::accumulate(tuple.begin(), tuple.end(), Rational());
    return tuple;
}

PatchPoint point(Random& random, const NetShape& shape, std::size_t bits) {
    PatchPoint point;
    for (const SimplexFactor& factor : shape.list())
        point.push_back(of_mass_one(tuple(random, factor.dimension, bits)));
    return point;
}

Coordinates folded(const NetShape& shape, const std::vector<std::vector<Rational>>& rows,
                   const PatchArguments& arguments) {
    Coordinates value;
    for (const auto& row : rows)
        value.push_back(constructions::folded_to_value<Rational>(shape, row, arguments));
    return value;
}

}  // namespace

TEST_CASE("patch values: values near the limits of words", "[differential]") {
    each_case("patch values", [&](Random& random) {
        const auto [net_shape, argument_bits, net] = random_net(random);
        const BezierPatch patch(net_shape, points(net));
        std::vector<PatchPoint> places;
        for (std::size_t i = 1 + random.below(9); i > 0; --i)
            places.push_back(point(random, net_shape, argument_bits));
        const PatchValues values(patch);
        const std::vector<Rational> batch = values.at(places, 1 + random.below(2));
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Coordinates expected = folded(net_shape, net, diagonal(net_shape, places[i]));
            CHECK(values(places[i]) == expected);
            CHECK(std::equal(expected.begin(), expected.end(),
                             batch.begin() + static_cast<std::ptrdiff_t>(i * net.size())));
        }
    });
}

TEST_CASE("patch blossoms: values near the limits of words", "[differential]") {
    each_case("patch blossoms", [&](Random& random) {
        const auto [net_shape, argument_bits, net] = random_net(random);
        PatchArguments arguments;
        for (const SimplexFactor& factor : net_shape.list()) {
            auto& list = arguments.emplace_back();
            while (list.size() < factor.degree) {
                const bool repeated = !list.empty() && random.one_in(3);
                list.push_back(repeated ? list[random.below(list.size())]
                                        : tuple(random, factor.dimension, argument_bits));
            }
        }
        CHECK(blossom_value(BezierPatch(net_shape, points(net)), arguments) ==
              folded(net_shape, net, arguments));
    });
}

TEST_CASE("polynomial patches: values near the limits of words", "[differential]") {
    each_case("polynomial patches", [&](Random& random) {
        const auto [net_shape, argument_bits, coefficients] = random_net(random);
        const PolynomialPatch patch(net_shape, points(coefficients));
        PatchPoint place;
        std::vector<std::vector<Rational>> monomials;
        for (const auto& [dimension, degree] : net_shape.list()) {
            place.push_back(tuple(random, dimension, argument_bits));
            place.back().front() = 1;
            monomials.push_back(constructions::monomials(place.back(), degree));
        }
        Coordinates expected;
        for (const auto& row : coefficients) {
            Rational sum;
            for (std::size_t i = 0; i < row.size(); ++i) {
                Rational term = row[i];
                std::size_t rest = i;
                for (std::size_t f = monomials.size(); f-- > 0;) {
                    term *= monomials[f][rest % monomials[f].size()];
                    rest /= monomials[f].size();
                }
                sum += term;
            }
            expected.push_back(sum);
        }
        CHECK(evaluate(patch, place) == expected);
    });
}

TEST_CASE("raised nets: numbers near the limits of words", "[differential]") {
    each_case("raised nets", [&](Random& random) {
        const NetShape net_shape = shape(random);
        const std::size_t f = random.below(net_shape.factors());
        const std::size_t limits[] = {63, 127, 200};
        const auto net = rows(random, net_shape, limits[random.below(3)] - random.below(6));
        const NetShape raised = net_shape.with_degree(f, net_shape[f].degree + 1);
        std::vector<std::vector<Rational>> expected;
        for (const auto& row : net) {
            auto& to = expected.emplace_back();
            for (std::vector<MultiIndex> index : net_indices(raised)) {
                Rational sum;
                for (std::size_t k = 0; k < index[f].size(); ++k) {
                    if (index[f][k] == 0) continue;
                    const Rational weight(index[f][k], raised[f].degree);
                    --index[f][k];
                    sum += weight * row[net_shape.position_of(index)];
                    ++index[f][k];
                }
                to.push_back(sum);
            }
        }
        CHECK(elevate(BezierPatch(net_shape, points(net)), f, 1).control_net() == points(expected));
    });
}

TEST_CASE("subdivided nets: numbers near the limits of words", "[differential]") {
    each_case("subdivided nets", [&](Random& random) {
        const NetShape net_shape = shape(random);
        const std::size_t f = random.below(net_shape.factors());
        const auto [argument_bits, net_bits] = sizes(random, NetShape({net_shape[f]}));
        const auto net = rows(random, net_shape, net_bits);
        Coordinates at = of_mass_one(tuple(random, net_shape[f].dimension, argument_bits));
        if (std::ranges::any_of(at, &Rational::is_zero)) at = Coordinates(at.size(), Rational(1, at.size()));
        const auto pieces = subdivide(BezierPatch(net_shape, points(net)), f, at);
        REQUIRE(pieces.size() == at.size());
        for (std::size_t v = 0; v < pieces.size(); ++v) {
            std::vector<std::vector<Rational>> expected;
            for (const auto& row : net) {
                expected.push_back(constructions::with_vertex_replaced<Rational>(
                    net_shape, f, v, constructions::pyramid<Rational>(net_shape, f, row, at)));
            }
            CHECK(pieces[v].control_net() == points(expected));
        }
    });
}
