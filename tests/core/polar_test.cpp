#include <blossom/core/algebra/resultant.hpp>
#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/blossom/polar.hpp>
#include <blossom/core/patch/net_bounds.hpp>
#include "core_test.hpp"

TEST_CASE("a polar at the remaining arguments is the blossom at all arguments") {
    Random random(412);
    for (const auto& dimensions : products_of_simplices()) {
        const BezierPatch net = patch(random, dimensions, Size::small, 10).patch();
        PatchArguments all(dimensions.size());
        PatchArguments fixed(dimensions.size());
        PatchArguments others(dimensions.size());
        for (std::size_t f = 0; f < dimensions.size(); ++f) {
            for (std::size_t i = 0; i < net.shape()[f].degree; ++i) {
                all[f].push_back(tuple_of_mass(random, dimensions[f], static_cast<int>(i % 2), Size::small));
                (i % 3 == 0 ? fixed : others)[f].push_back(all[f].back());
            }
        }
        CHECK(blossom_value(polar(net, fixed), others) == blossom_value(net, all));
    }
}

TEST_CASE("the restriction to a simplex has the control points that are blossom values at its vertices") {
    Random random(413);
    const BezierPatch net = patch(random, {2}, Size::small, 6).patch();
    const std::size_t n = net.shape()[0].degree;
    const Coordinates from{Rational(1, 2), Rational(1, 2), 0};
    const Coordinates to{Rational(1, 3), Rational(-1, 3), 1};
    const std::vector<PatchPoint> ends{{from}, {to}};
    const BezierPatch segment = restricted(net, ends);
    for (std::size_t k = 0; k <= n; ++k) {
        PatchArguments arguments(1, std::vector<Coordinates>(n - k, from));
        arguments[0].insert(arguments[0].end(), k, to);
        CHECK(segment.control_net()[k] == blossom_value(net, arguments));
    }
    // Dependent vertices, of which the first is there twice.
    const std::vector<PatchPoint> dependent{{from}, {to}, {from}};
    CHECK(evaluate(restricted(net, dependent), {{Rational(1, 4), Rational(1, 2), Rational(1, 4)}}) ==
          evaluate(segment, {{Rational(1, 2), Rational(1, 2)}}));
}

TEST_CASE("the bounds of a map that touches zero between all nets stay undecided") {
    // (3 x - 1)^2
    const std::vector<Coordinates> points{{1}, {-2}, {4}};
    const PlacedPatch piece{BezierPatch(NetShape::segment(2), points),
                            {BarycentricFrame(std::vector<Coordinates>{{0}, {1}})}};
    const NetBounds bounds = net_bounds(std::span(&piece, 1), 6);
    CHECK(bounds.positivity == Positivity::undecided);
    CHECK(*bounds.lower < 0);
    CHECK(*bounds.lower > Rational(-1, 100));
    CHECK(*bounds.upper == 4);
}

TEST_CASE("the resultant is the determinant of Sylvester's matrix") {
    const Polynomial t = Polynomial::monomial(1);
    CHECK(resultant(t * t - Polynomial(2), t * t * t - t - Polynomial(1)) == -1);
    CHECK(resultant(t - Polynomial(3), Polynomial(2) * t + Polynomial(5)) == 11);
    CHECK(resultant(Polynomial(2) * t + Polynomial(5), t - Polynomial(3)) == -11);
    CHECK(resultant(Polynomial(3), t * t) == 9);
    CHECK(resultant(t * t, Polynomial(3)) == 9);
    CHECK(resultant(Polynomial(), t) == 0);
    CHECK(resultant(Polynomial(2), Polynomial(5)) == 1);
    CHECK(resultant(t * (t - Polynomial(1)), t - Polynomial(1)) == 0);
}
