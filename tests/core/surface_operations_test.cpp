#include <blossom/core/patch/curve_along.hpp>
#include <blossom/core/patch/edge_contact.hpp>
#include <blossom/core/patch/patch_reduction.hpp>
#include <blossom/core/patch/tangent_contact.hpp>
#include <blossom/core/patch/tensor_bspline_change.hpp>
#include "core_test.hpp"

namespace {

/// u v^2 over the unit square, and its graph (u, v, u v^2).
PlacedPatch product_patch(bool graph) {
    std::vector<Coordinates> points;
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Rational value(i * (k / 2));
            points.push_back(graph ? Coordinates{Rational(i), Rational(k, 2), value} : Coordinates{value});
        }
    }
    const std::vector<std::size_t> degrees{1, 2};
    return {BezierPatch(NetShape::tensor(degrees), points), std::vector(2, BarycentricFrame({{0}, {1}}))};
}

}  // namespace

TEST_CASE("the curve along a direction has the rows side by side, and gives the map back") {
    const PlacedPatch patch = product_patch(true);
    const BezierCurve rows = curve_along(patch, 1);
    CHECK(rows.dimension() == 6);
    CHECK(rows.control_points()[2] == Coordinates{0, 1, 0, 1, 1, 1});
    CHECK(with_curve_along(patch, 1, rows).patch.control_net().to_points() ==
          patch.patch.control_net().to_points());
    const TensorBSpline spline = bspline_of(patch);
    for (const std::size_t d : {std::size_t{0}, std::size_t{1}})
        CHECK(with_curve_along(spline, d, curve_along(spline, d)) == spline);
    CHECK(failure_code([&] { with_curve_along(patch, 0, rows); }) == ErrorCode::mismatched_dimensions);
    const PlacedPatch triangle{BezierPatch(NetShape::simplex(2, 0), std::vector<Coordinates>{{1}}),
                               {BarycentricFrame::standard(2)}};
    CHECK(failure_code([&] { curve_along(triangle, 0); }) == ErrorCode::mismatched_dimensions);
}

TEST_CASE("the integral of a square is that over the domain") {
    const PlacedPatch patch = product_patch(false);
    CHECK(integral_of_square(patch.patch, patch.frames) == Rational(1, 15));
    const std::vector<BarycentricFrame> wide{BarycentricFrame({{3}, {1}}), BarycentricFrame({{0}, {3}})};
    CHECK(integral_of_square(patch.patch, wide) == Rational(6, 15));
    const BezierPatch one(NetShape::simplex(2, 0), std::vector<Coordinates>{{2}});
    const std::vector<BarycentricFrame> triangle{BarycentricFrame({{0, 0}, {0, 4}, {3, 0}})};
    CHECK(integral_of_square(one, triangle) == 24);
    CHECK(integral_of_square(one, {}) == 2);
}

TEST_CASE("least squares in both directions have no component of the lower degrees left") {
    const PlacedPatch patch = product_patch(false);
    const std::vector<std::size_t> degrees{1, 1};
    const PatchReduction reduced = reduce(patch.patch, patch.frames, degrees, ReductionMethod::least_squares);
    // The best line to v^2 is v - 1/6, at a distance whose square has the integral 1/180; that of u^2 is 1/3.
    CHECK(reduced.patch.control_net().to_points() ==
          std::vector<Coordinates>{{0}, {0}, {Rational(-1, 6)}, {Rational(5, 6)}});
    CHECK(reduced.l2_squared == Rational(1, 540));
    CHECK_FALSE(reduced.exact());
}

TEST_CASE("a graph and its mirror image have one tangent plane where its slope across the edge is 0") {
    const PlacedPatch patch = product_patch(true);
    const Joint joint{0, 0, {{0, 0}, {0, 1}, {1, 0}}, {{0, 0}, {0, 1}, {-1, 0}}};
    const TangentContact same = tangent_contact(std::span(&patch, 1), std::span(&patch, 1), joint, false);
    CHECK(same.kind == TangentContact::Kind::folded);
    CHECK(same.functions == std::vector<Polynomial>{1, -1, 0});
    const Joint other{0, 0, {{0, 0}, {0, 1}, {1, 0}}, {{1, 0}, {1, 1}, {2, 0}}};
    CHECK(tangent_contact(std::span(&patch, 1), std::span(&patch, 1), other, false).kind ==
          TangentContact::Kind::apart);
}
