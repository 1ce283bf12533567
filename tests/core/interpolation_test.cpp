#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/curve/interpolation.hpp>
#include <blossom/core/patch/net_interpolation.hpp>
#include <blossom/core/spline/greville.hpp>
#include <blossom/core/spline/spline_interpolation.hpp>
#include "core_test.hpp"

namespace {

std::vector<Rational> some_nodes(Random& random, std::size_t count) {
    std::vector<Rational> nodes;
    for (std::size_t i = 0; i < count; ++i)
        nodes.push_back(i > 0 && random.one_in(3) ? nodes[random.below(i)] : small_rational(random));
    return nodes;
}

/// derivative(node, order) for each node, the order as often as the node occurs before.
template <class Derivative>
std::vector<Coordinates> data_of(std::span<const Rational> nodes, const Derivative& derivative) {
    std::vector<Coordinates> values;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        values.push_back(
            derivative(nodes[i], static_cast<std::size_t>(std::ranges::count(nodes.first(i), nodes[i]))));
    }
    return values;
}

}  // namespace

TEST_CASE("a polynomial is determined by values and derivatives at as many nodes as coefficients",
          "[interpolation]") {
    Random random(421);
    for (std::size_t round = 0; round < 300; ++round) {
        const std::size_t n = round % 10;
        const PolynomialCurve curve = polynomial_map(random, n, Size::small).curve();
        const std::vector<Rational> nodes = some_nodes(random, n + 1);
        CHECK(interpolate(nodes, data_of(nodes, [&](const Rational& t, std::size_t order) {
                              return derivative(curve, order, t);
                          })) == curve);
    }
    const std::vector<Coordinates> two{{1}, {2}};
    CHECK(failure_code([&] { interpolate(std::vector<Rational>{0}, two); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([&] { interpolate(std::vector<Rational>(), std::vector<Coordinates>()); }) ==
          ErrorCode::wrong_arity);
    CHECK(failure_code([&] {
              interpolate(std::vector<Rational>{0, 1}, std::vector<Coordinates>{{1}, {2, 3}});
          }) == ErrorCode::mismatched_dimensions);
}

TEST_CASE("a spline is determined by values at its Greville abscissae", "[interpolation]") {
    Random random(422);
    std::size_t determined = 0;
    for (int round = 0; round < 200; ++round) {
        const BSplineCurve curve = spline(random, 1 + random.below(5)).curve();
        std::vector<Rational> nodes = greville_abscissae(curve.knots());
        const Interval domain = curve.knots().domain();
        if (nodes.front() < domain.a() || nodes.back() > domain.b() ||
            std::ranges::adjacent_find(nodes) != nodes.end()) {
            continue;
        }
        ++determined;
        const std::vector<Coordinates> values =
            data_of(nodes, [&](const Rational& t, std::size_t) { return de_boor(curve, t); });
        CHECK(interpolate(curve.knots(), nodes, values) == curve);
    }
    CHECK(determined > 30);
}

TEST_CASE("nodes that do not determine a spline are refused with the B-spline that fails",
          "[interpolation]") {
    const KnotVector knots(1, {0, 0, 1, 2, 3, 3}, 4);
    const std::vector<Coordinates> values(4, Coordinates{1});
    const auto message = [&](std::vector<Rational> nodes) {
        const auto error = failure([&] { interpolate(knots, nodes, values); });
        REQUIRE(error);
        CHECK(error->code() == ErrorCode::missing_sample);
        return error->message();
    };
    CHECK(
        message({0, Rational(1, 4), Rational(1, 2), 3}) ==
        "the nodes do not determine the spline: B-spline 2 is 0 at all of them, none lies inside its support "
        "[1, 3]");
    CHECK(
        message({0, Rational(1, 4), Rational(1, 2), Rational(5, 2)}) ==
        "the nodes do not determine the spline: in increasing order, datum 2 is the value at 1/2, which does "
        "not involve B-spline 2 on [1, 3]");
    CHECK(
        message({0, 0, 0, 2}) ==
        "the nodes do not determine the spline: in increasing order, datum 2 is the derivative of order 2 at "
        "0, which does not involve B-spline 2 on [1, 3]");
    const auto outside = failure([&] { interpolate(knots, std::vector<Rational>{0, 4, 0, 1}, values); });
    REQUIRE(outside);
    CHECK(outside->code() == ErrorCode::outside_domain);
    CHECK(outside->place() == Part::nodes / 1);
    CHECK(failure_code([&] { interpolate(knots, std::vector<Rational>{0, 1, 2}, values); }) ==
          ErrorCode::wrong_arity);
}

TEST_CASE("a map on a simplex is determined by its values on the principal lattice", "[interpolation]") {
    Random random(423);
    for (std::size_t round = 0; round < 60; ++round) {
        const SimplexFactor simplex{round % 4, round / 4 % 5};
        const NetShape shape = NetShape::simplex(simplex.dimension, simplex.degree);
        std::vector<Coordinates> net;
        for (std::size_t i = 0; i < shape.size(); ++i)
            net.push_back({rational(random), small_rational(random)});
        const BezierPatch patch(shape, net);
        std::vector<Coordinates> values;
        for (const MultiIndex& index : multi_indices(simplex.dimension, simplex.degree)) {
            Coordinates point(index.size());
            for (std::size_t k = 0; k < index.size(); ++k)
                point[k] = simplex.degree > 0 ? Rational(index[k], simplex.degree) : Rational(k == 0 ? 1 : 0);
            values.push_back(evaluate(patch, PatchPoint{point}));
        }
        CHECK(interpolate_on_lattice(simplex, PointArray(values)) == patch);
    }
}
