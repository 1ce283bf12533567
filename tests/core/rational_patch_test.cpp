#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/nurbs/rational_curve.hpp>
#include <blossom/core/nurbs/rational_patch.hpp>
#include <blossom/core/nurbs/rational_spline.hpp>
#include <blossom/core/patch/patch_contact.hpp>
#include <blossom/core/patch/patch_conversion.hpp>
#include <blossom/core/patch/patch_derivative.hpp>
#include <blossom/core/patch/tensor_bspline_contact.hpp>
#include "core_test.hpp"

// Quotients of patches: derived maps compared with values, and contact compared with maps constructed to have
// it.

namespace {

/// The derivative in directions of the whole domain: the sum over all assignments of directions to factors.
Coordinates derivative_of(const BezierPatch& patch, std::span<const PatchPoint> directions,
                          const PatchPoint& at) {
    Coordinates sum(patch.dimension());
    std::vector<std::size_t> factors(directions.size());
    for (;;) {
        PatchArguments lists(patch.shape().factors());
        for (std::size_t k = 0; k < directions.size(); ++k)
            lists[factors[k]].push_back(directions[k][factors[k]]);
        const Coordinates value = derivative(patch, lists, at);
        for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += value[j];
        std::size_t k = 0;
        while (k < factors.size() && ++factors[k] == patch.shape().factors()) factors[k++] = 0;
        if (k == factors.size()) return sum;
    }
}

const SparsePolynomial x = SparsePolynomial::variable(0);
const SparsePolynomial y = SparsePolynomial::variable(1);

PlacedPatch over(const std::vector<SparsePolynomial>& coordinates, const NetShape& shape,
                 const std::vector<BarycentricFrame>& frames) {
    return {control_net(PolynomialPatch(shape, coordinates), frames), frames};
}

SparsePolynomial power(const SparsePolynomial& base, std::size_t exponent) {
    SparsePolynomial result(1);
    for (std::size_t i = 0; i < exponent; ++i) result = result * base;
    return result;
}

}  // namespace

TEST_CASE("rational patches: the derived map has the derivatives of the quotient") {
    Random random(871);
    for (const auto& dimensions : products_of_simplices()) {
        PatchRecipe recipe = patch(random, dimensions, Size::small, 12);
        for (auto& [index, point] : recipe.points) point.push_back(small_rational(random));
        const BezierPatch homogeneous = recipe.patch();
        for (std::size_t order = 0; order <= 3; ++order) {
            std::vector<PatchPoint> directions(std::min<std::size_t>(order, 2));
            for (PatchPoint& direction : directions) {
                for (const std::size_t s : dimensions)
                    direction.push_back(tuple_of_mass(random, s, 0, Size::small));
            }
            // One direction occurs twice.
            if (order == 3) directions.push_back(directions.front());
            PatchPoint at;
            for (const std::size_t s : dimensions) at.push_back(tuple_of_mass(random, s, 1, Size::small));
            if (evaluate(homogeneous, at).back().is_zero()) continue;
            const BezierPatch derived = rational_derivative_patch(homogeneous, directions);
            for (std::size_t f = 0; f < dimensions.size(); ++f)
                CHECK(derived.shape()[f].degree == (order + 1) * homogeneous.shape()[f].degree);
            CHECK(projected(evaluate(derived, at)) == rational_derivative(homogeneous, directions, at));
            CHECK(directional_derivative(homogeneous, directions, at) ==
                  derivative_of(homogeneous, directions, at));
            CHECK(evaluate(directional_derivative_patch(homogeneous, directions), at) ==
                  derivative_of(homogeneous, directions, at));
        }
    }
}

TEST_CASE("rational patches: the derived map of a quotient of polynomials, written out") {
    // d/dx of x y / (1 + x) is y / (1 + x)^2, and d/dy of this is 1 / (1 + x)^2; the function gives the
    // denominator (1 + x)^3.
    const PolynomialPatch map(NetShape::simplex(2, 2), std::vector{x * y, SparsePolynomial(1) + x});
    const std::vector<PatchPoint> directions{{{0, 1, 0}}, {{0, 0, 1}}};
    const PolynomialPatch once = rational_derivative_patch(map, std::span(directions).first(1));
    CHECK(once.coordinate(0) == y);
    CHECK(once.coordinate(1) == power(SparsePolynomial(1) + x, 2));
    const PolynomialPatch twice = rational_derivative_patch(map, directions);
    CHECK(twice.coordinate(0) == SparsePolynomial(1) + x);
    CHECK(twice.coordinate(1) == power(SparsePolynomial(1) + x, 3));
    CHECK(rational_derivative_patch(map, {}) == map);
}

TEST_CASE("rational patches: a derived map that would be too large, or is of nothing, is refused") {
    const PolynomialPatch map(NetShape::simplex(2, 2), std::vector{x * y, SparsePolynomial(1) + x});
    const std::vector<PatchPoint> direction{{{0, 1, 0}}};
    Limits limits;
    limits.numbers = 35;
    CHECK(failure_code([&] { rational_derivative_patch(map, direction, limits); }) ==
          ErrorCode::limit_exceeded);
    limits.numbers = 36;
    CHECK(rational_derivative_patch(map, direction, limits).shape().size() == 15);
    // Order 1 needs 2 products per coordinate of 6 by 6 coefficients.
    limits = {};
    limits.expansion_work = 143;
    CHECK(failure_code([&] { rational_derivative_patch(map, direction, limits); }) ==
          ErrorCode::limit_exceeded);
    limits.expansion_work = 144;
    CHECK(rational_derivative_patch(map, direction, limits).shape().size() == 15);
    limits = {};
    limits.degree = 3;
    CHECK(failure_code([&] { rational_derivative_patch(map, direction, limits); }) ==
          ErrorCode::limit_exceeded);
    const PolynomialPatch nothing(NetShape::simplex(2, 1), std::vector{x, SparsePolynomial()});
    CHECK(failure_code([&] { rational_derivative_patch(nothing, direction); }) == ErrorCode::zero_weight);
}

TEST_CASE("rational patches: the contact is that of the quotients, whatever factor they share") {
    const std::vector<BarycentricFrame> left_triangle{BarycentricFrame({{0, 0}, {1, 0}, {0, 1}})};
    const std::vector<BarycentricFrame> right_triangle{BarycentricFrame({{1, 1}, {1, 0}, {0, 1}})};
    const std::vector<BarycentricFrame> left_box{BarycentricFrame::standard(1),
                                                 BarycentricFrame::standard(1)};
    const std::vector<BarycentricFrame> right_box{BarycentricFrame({{1}, {2}}),
                                                  BarycentricFrame::standard(1)};
    const SparsePolynomial one(1);
    const SparsePolynomial weight = one + x + 2 * y;
    const SparsePolynomial factor = one + one + x;
    const std::vector<SparsePolynomial> map{x * y, x + one, weight};
    const std::vector<SparsePolynomial> same{map[0] * factor, map[1] * factor, weight * factor};
    const auto check = [&](const auto& left_frames, const auto& right_frames, const NetShape& low,
                           const NetShape& high, const SparsePolynomial& distance) {
        const PlacedPatch left = over(map, low, left_frames);
        const Face face = shared_face(left_frames, right_frames).face;
        CHECK(projected_contact(left, over(same, high, right_frames), face).is_infinite());
        CHECK(contact(left, over(same, high, right_frames), face).order == -1);
        for (std::size_t order = 0; order <= 3; ++order) {
            std::vector<SparsePolynomial> other = same;
            other[1] = other[1] + power(distance, order) * (one + y);
            const PlacedPatch right = over(other, high, right_frames);
            const PatchContact found = projected_contact(left, right, face);
            CHECK(found.order == static_cast<std::ptrdiff_t>(order) - 1);
            CHECK(projected_contact(right, left, shared_face(right_frames, left_frames).face).order ==
                  found.order);
        }
    };
    check(left_triangle, right_triangle, NetShape::simplex(2, 2), NetShape::simplex(2, 5), one - x - y);
    check(left_box, right_box, NetShape::tensor(std::vector<std::size_t>{1, 1}),
          NetShape::tensor(std::vector<std::size_t>{4, 2}), x - one);

    const PlacedPatch vanishing = over({x, one - x - y}, NetShape::simplex(2, 1), left_triangle);
    const PlacedPatch fine = over({x, one}, NetShape::simplex(2, 1), right_triangle);
    const Face face = shared_face(left_triangle, right_triangle).face;
    CHECK(failure_code([&] { projected_contact(vanishing, fine, face); }) == ErrorCode::zero_weight);
    CHECK(failure_code([&] {
              projected_contact(fine, vanishing, shared_face(right_triangle, left_triangle).face);
          }) == ErrorCode::zero_weight);
    const PlacedPatch weights_alone = over({one}, NetShape::simplex(2, 1), left_triangle);
    CHECK(failure_code([&] { projected_contact(weights_alone, weights_alone, face); }) ==
          ErrorCode::mismatched_dimensions);
}

TEST_CASE("tensor B-splines: contact at knots, the least along all rows") {
    Random random(872);
    const KnotVector cubic(3, {0, 0, 0, 0, 1, Rational(3, 2), Rational(3, 2), 4, 4, 4, 4}, 7);
    const KnotVector quadratic(2, {-1, 0, Rational(1, 3), 1, 2, 3, 5}, 4);
    std::vector<Coordinates> points;
    for (std::size_t i = 0; i < 28; ++i) points.push_back({small_rational(random), Rational(1)});
    // Each row is one polynomial, except the last, whose spline has the order of contact that its knots give.
    for (std::size_t i = 0; i < 7; ++i) {
        for (std::size_t j = 0; j < 3; ++j) points[i * 4 + j] = {1, 1};
    }
    const TensorBSpline surface({cubic, quadratic}, points);
    for (const bool divided : {false, true}) {
        const auto order = [&](std::size_t direction, const Rational& at) {
            return (divided ? projected_contact(surface, direction, at) : contact(surface, direction, at))
                .order;
        };
        CHECK(order(0, 1) == 2);
        CHECK(order(0, Rational(3, 2)) == 1);
        CHECK(!order(0, 2));
        CHECK(order(1, 1) == 1);
    }
    CHECK(failure_code([&] { contact(surface, 0, 4); }) == ErrorCode::outside_domain);
}

TEST_CASE("tensor B-splines: a later box along a knot may be less smooth than the first") {
    // Rows over a knot of multiplicity 2: two of them are as smooth as over a simple knot, the last one is
    // not.
    const BSplineCurve simple(3, {0, 0, 0, 0, 1, 2, 2, 2, 2}, {{0}, {1}, {0}, {5}, {-1}});
    const BSplineCurve smooth = insert_knots_boehm(simple, std::vector<Rational>{1});
    std::vector<Coordinates> points;
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 2; ++j) points.push_back(smooth.control_points()[i]);
        points.push_back({Rational(i * i * i * i)});
    }
    const KnotVector linear(1, {0, 0, 1, 2, 2}, 3);
    CHECK(contact(TensorBSpline({smooth.knots(), linear}, points), 0, 1).order == 1);
    for (std::size_t i = 0; i < 6; ++i) points[3 * i + 2] = points[3 * i];
    CHECK(contact(TensorBSpline({smooth.knots(), linear}, points), 0, 1).order == 2);
}

TEST_CASE("tensor B-splines: the contact of a rational surface is that of the curve that it is swept from") {
    const KnotVector arcs(2, {0, 0, 0, 1, 1, 2, 2, 2}, 5), height(1, {0, 0, 1, 1}, 2);
    const auto check = [&](const Rational& last_weight) {
        std::vector<Coordinates> curve{
            {1, 0, 1}, {1, 1, 1}, {0, 2, 2}, {-1, 1, 1}, {-last_weight, 0, last_weight}};
        std::vector<Coordinates> points;
        for (const Coordinates& xyw : curve) {
            for (const int z : {0, 3}) points.push_back({xyw[0], xyw[1], Rational(z) * xyw[2], xyw[2]});
        }
        const auto expected = projected_contact(BSplineCurve(arcs, curve), 1).order;
        CHECK(projected_contact(TensorBSpline({arcs, height}, points), 0, 1).order == expected);
    };
    check(1);
    check(2);
    check(Rational(1, 3));
}
