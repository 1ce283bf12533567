#include <blossom/core/patch/combined_maps.hpp>
#include "core_test.hpp"

namespace {

BezierCurve curve(std::vector<Coordinates> points, const Interval& interval) {
    return BezierCurve(points, interval);
}

}  // namespace

TEST_CASE("a map that is polynomial in the coordinates of curves has the values of this polynomial") {
    const Interval interval(-1, 2);
    const std::vector<BezierCurve> curves{curve({{1, 2}, {0, 3}, {5, -1}}, interval),
                                          curve({{2, 0}, {-1, 4}}, interval)};
    // det(P, Q) + 3 P_0 - 7, and P_1^2 Q_0
    CoordinateSums sums = determinant(2);
    sums[0].push_back({{{0, 0}}, 3});
    sums[0].push_back({{}, -7});
    sums.push_back({{{{0, 1}, {0, 1}, {1, 0}}}});
    const BezierCurve result = combined(std::span<const BezierCurve>(curves), sums);
    CHECK(result.degree() == 5);
    for (const int t : {-1, 0, 1, 2, 5}) {
        const Coordinates p = evaluate(curves[0], t);
        const Coordinates q = evaluate(curves[1], t);
        CHECK(evaluate(result, t) ==
              Coordinates{p[0] * q[1] - p[1] * q[0] + Rational(3) * p[0] - Rational(7), p[1] * p[1] * q[0]});
    }
}

TEST_CASE("curves over different intervals are not combined") {
    const std::vector<BezierCurve> curves{curve({{1}, {2}}, Interval(0, 1)),
                                          curve({{1}, {2}}, Interval(0, 2))};
    const std::vector<Rational> factors{1, 1};
    const auto refused =
        failure([&] { combined(std::span<const BezierCurve>(curves), linear_combination(factors, 1)); });
    REQUIRE(refused);
    CHECK(refused->code() == ErrorCode::outside_domain);
    CHECK(refused->place() == Part::maps / 1);
}

TEST_CASE("sums of splines over the same knots stay over them, and products get the knots of both") {
    const BSplineCurve left(1, {-1, 0, 1, 3, 4}, {{1}, {2}, {5}});
    const BSplineCurve right(1, {0, 0, 2, 3, 3}, {{1}, {0}, {1}});
    const std::vector<Rational> factors{2, -1};
    const std::vector<BSplineCurve> same{left, left};
    CHECK(combined(std::span<const BSplineCurve>(same), linear_combination(factors, 1)) == left);
    const std::vector<BSplineCurve> both{left, right};
    const std::vector<std::size_t> dimensions{1, 1};
    const BSplineCurve result = combined(std::span<const BSplineCurve>(both), scalar_multiple(dimensions));
    CHECK(result.knots().knots() == std::vector<Rational>{0, 0, 0, 1, 1, 2, 2, 3, 3, 3});
    for (const Rational& t : {Rational(0), Rational(1, 2), Rational(3, 2), Rational(2), Rational(3)})
        CHECK(de_boor(result, t)[0] == de_boor(left, t)[0] * de_boor(right, t)[0]);
}

TEST_CASE("rational maps that share a weight keep it, and others are brought to a common denominator") {
    const std::optional<CoordinateOf> own = CoordinateOf{0, 1};
    const std::vector<Rational> factors{1, 1};
    const std::vector<std::optional<CoordinateOf>> shared{own, own};
    const std::vector<std::optional<CoordinateOf>> one{own, std::nullopt};
    const CoordinateSums together = projective(linear_combination(factors, 1), shared);
    CHECK(together[0][0].coordinates == std::vector{CoordinateOf{0, 0}});
    CHECK(together[1][0].coordinates == std::vector{CoordinateOf{0, 1}});
    const CoordinateSums apart = projective(linear_combination(factors, 1), one);
    CHECK(apart[0][1].coordinates == std::vector{CoordinateOf{1, 0}, CoordinateOf{0, 1}});
}
