// What every value type has: a text, a hash, a valid state after a move, and checked preconditions.

#include <blossom/core/algebra/sparse_polynomial.hpp>
#include <blossom/core/blossom/blossom.hpp>
#include <blossom/core/curve/derivative.hpp>
#include <blossom/core/maps/hermite_curve.hpp>
#include <blossom/core/maps/polynomial_patch.hpp>
#include <blossom/core/maps/taylor_curve.hpp>
#include <blossom/core/patch/tensor_bspline.hpp>
#include <blossom/core/spline/knot_insertion.hpp>
#include <blossom/rational/format.hpp>

#include <sstream>
#include <unordered_set>

#include "support/catch.hpp"
#include "support/failure.hpp"

namespace {

using namespace blossom;
using testing::failure_code;

static_assert(Value<Integer> && Value<Rational> && Value<RationalVector> && Value<Polynomial>);
static_assert(Value<SparsePolynomial> && Value<Parameter> && Value<Direction> && Value<Argument>);
static_assert(Value<Interval> && Value<PointArray> && Value<PolynomialCurve> && Value<BezierCurve>);
static_assert(Value<TaylorCurve> && Value<HermiteCurve> && Value<KnotVector> && Value<BSplineCurve>);
static_assert(Value<NetShape> && Value<BezierPatch> && Value<PolynomialPatch> && Value<TensorBSpline>);
static_assert(!Value<int> && !Value<std::string> && !Value<Coordinates>);

template <class T>
std::string printed(const T& value) {
    std::ostringstream stream;
    stream << value;
    CHECK(stream.str() == to_string(value));
    CHECK(fmt::format("{}", value) == to_string(value));
    CHECK(fmt::format("{:>100}", value).size() >= 100);
    return stream.str();
}

// Equal values have equal hashes, and these different ones different hashes.
template <class T>
void require_hashes(const T& value, const T& other) {
    CHECK(std::hash<T>{}(value) == std::hash<T>{}(T(value)));
    CHECK(std::hash<T>{}(value) != std::hash<T>{}(other));
    CHECK(std::unordered_set<T>{value, other, value}.size() == 2);
}

const Rational half(1, 2);

}  // namespace

TEST_CASE("values print as their texts") {
    CHECK(printed(Integer(-7)) == "-7");
    CHECK(printed(half) == "1/2");
    CHECK(printed(RationalVector({half, 3})) == "(1/2, 3)");
    CHECK(printed(Polynomial({1, 0, half})) == "1 + 1/2 t^2");
    CHECK(printed(SparsePolynomial::variable(1)) == "x2");
    CHECK(printed(Parameter(half)) == "1/2");
    CHECK(printed(delta) == "1 delta");
    CHECK(printed(Argument(half, 2)) == "(1/2, 2)");
    CHECK(printed(Interval(0, half)) == "[0, 1/2]");
    CHECK(printed(PointArray({{0, 1}, {half, 2}})) == "(0, 1), (1/2, 2)");
    CHECK(printed(PolynomialCurve({{1, 0}, {0, 2}, {half, 0}})) == "(1 + 1/2 t^2, 2t) of degree 2");
    CHECK(printed(BezierCurve({{0}, {1}})) == "control points (0), (1) over [0, 1]");
    CHECK(printed(TaylorCurve{half, PointArray({{0}, {1}})}) == "Taylor coefficients (0), (1) at 1/2");
    CHECK(printed(HermiteCurve(std::vector<Coordinates>{{0}}, std::vector<Coordinates>{{1}})) ==
          "(0), (1), the first 1 at 0, the others at 1");
    CHECK(printed(BSplineCurve(1, {0, 0, 1, 1}, {{0}, {1}})) ==
          "degree 1, knots 0, 0, 1, 1, control points (0), (1)");
    CHECK(printed(BezierPatch(NetShape::simplex(2, 1), PointArray({{0}, {1}, {2}}))) ==
          "degree 1 on a simplex of dimension 2, control net (0), (1), (2)");
    CHECK(printed(PolynomialPatch(NetShape::simplex(2, 1), PointArray({{0}, {1}, {2}}))) ==
          "degree 1 on a simplex of dimension 2, coefficients (0), (1), (2)");
    CHECK(printed(TensorBSpline({KnotVector(0, {0, 1}, 1), KnotVector(1, {0, 0, 1, 1}, 2)}, {{0}, {1}})) ==
          "degree 0, knots 0, 1; degree 1, knots 0, 0, 1, 1; control points (0), (1)");
}

TEST_CASE("values have hashes") {
    require_hashes(Integer(1), Integer(2));
    require_hashes(pow(Integer(3), 100), pow(Integer(3), 101));
    require_hashes(half, Rational(2));
    require_hashes(Polynomial({1, 2}), Polynomial({2, 1}));
    require_hashes(SparsePolynomial::variable(0), SparsePolynomial::variable(1));
    require_hashes(Argument(1, 0), Argument(0, 1));
    require_hashes(BezierCurve({{0}, {1}}), BezierCurve({{0}, {1}}, Interval(0, 2)));
    require_hashes(BSplineCurve(1, {0, 0, 1, 1}, {{0}, {1}}), BSplineCurve(1, {0, 0, 2, 2}, {{0}, {1}}));

    const RationalVector reduced({half, 1});
    const RationalVector unreduced({2, 4}, 4);
    CHECK(reduced == unreduced);
    CHECK(hash_value(reduced) == hash_value(unreduced));
}

TEST_CASE("a value that was moved from is valid or refuses its use") {
    Integer large = pow(Integer(10), 40);
    const Integer taken_integer = std::move(large);
    CHECK(large == 0);  // NOLINT(bugprone-use-after-move)
    Rational number(1, 3);
    const Rational taken_number = std::move(number);
    CHECK(number + 1 == 1);  // NOLINT(bugprone-use-after-move)
    RationalVector list({half, 1});
    const RationalVector taken_list = std::move(list);
    CHECK(list == RationalVector());  // NOLINT(bugprone-use-after-move)
    Polynomial polynomial({1, 2});
    const Polynomial taken_polynomial = std::move(polynomial);
    CHECK(polynomial.is_zero());  // NOLINT(bugprone-use-after-move)
    BezierCurve curve({{0}, {1}});
    const BezierCurve taken_curve = std::move(curve);
    CHECK_THROWS_AS(curve.degree(), Error);  // NOLINT(bugprone-use-after-move)
    CHECK_THROWS_AS(derivative(curve, 1, Parameter(0)), Error);
    curve = taken_curve;
    CHECK(curve.degree() == 1);
}

TEST_CASE("powers and shifts") {
    CHECK(pow(half, -2) == 4);
    CHECK(pow(half, 3) == Rational(1, 8));
    CHECK(pow(Rational(0), 0) == 1);
    CHECK(pow(Rational(-1), pow(Integer(10), 30) + 1) == -1);
    CHECK(pow(Integer(-1), std::size_t{1'000'000'000'001}) == -1);
    CHECK(failure_code([] { pow(Rational(0), -1); }) == ErrorCode::division_by_zero);
    CHECK(failure_code([] { pow(half, std::int64_t{100'000'000'000}); }) == ErrorCode::limit_exceeded);
    CHECK(failure_code([] { pow(half, pow(Integer(10), 30)); }) == ErrorCode::limit_exceeded);
    CHECK(failure_code([] { pow(Integer(2), -1); }) == ErrorCode::wrong_kind);
    CHECK(failure_code([] { pow(Polynomial({1, 1}), std::int64_t{1} << 40); }) == ErrorCode::limit_exceeded);
    CHECK(failure_code([] { Integer(1) << std::int64_t{100'000'000'000}; }) == ErrorCode::limit_exceeded);
    CHECK(failure_code([] { Integer(1) << -1; }) == ErrorCode::wrong_kind);
    CHECK(Integer(0) << std::int64_t{100'000'000'000} == 0);
    CHECK(Integer(3) << 64 >> 64 == 3);
    // Half as long as the longest number of either backend.
    const auto power_of_two = [](std::size_t exponent) { return Integer(1) << (std::size_t{1} << exponent); };
    const std::size_t exponent = failure_code([&] { power_of_two(32); }) ? 30 : 32;
    const Integer long_number = power_of_two(exponent);
    CHECK(long_number.bit_length() == (std::size_t{1} << exponent) + 1);
    CHECK(failure_code([&] { Integer(long_number) *= long_number; }) == ErrorCode::limit_exceeded);
}

TEST_CASE("indices and sizes are checked") {
    const BSplineCurve spline(1, {0, 0, 1, 2, 2}, {{0}, {1}, {0}});
    CHECK(failure_code([&] { spline.points_of(50); }) == ErrorCode::outside_domain);
    CHECK(failure_code([&] { spline.points_of(0); }) == ErrorCode::outside_domain);
    CHECK(spline.points_of(1).size() == 2);
    CHECK(failure_code([&] { spline.knots()[5]; }) == ErrorCode::outside_domain);
    CHECK(failure_code([&] { spline.knots().window(3); }) == ErrorCode::outside_domain);
    CHECK(failure_code([&] { spline.knots().around(3); }) == ErrorCode::outside_domain);
    const PointArray points({{0, 1}, {2, 3}});
    CHECK(failure_code([&] { points[2]; }) == ErrorCode::outside_domain);
    CHECK(failure_code([&] { points.coordinate(2); }) == ErrorCode::outside_domain);
    CHECK(failure_code([&] { points.numbers()[4]; }) == ErrorCode::outside_domain);
    CHECK(failure_code([] { PointArray(0, RationalVector()); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([] { PointArray(0, RationalVector({1})); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([] { PointArray(2, RationalVector({1})); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([] { NetShape::simplex(2, -1); }) == ErrorCode::wrong_kind);
    CHECK(failure_code([] { NetShape::simplex(2, 1)[1]; }) == ErrorCode::outside_domain);
}

TEST_CASE("maps and calls in braces") {
    const BezierCurve curve({{0, 0}, {1, 2}, {2, 0}});
    const Blossom p(curve);
    CHECK(p({0, half}) == Coordinates{half, 1});
    CHECK(p({0, delta}) == Coordinates{1, 2});
    CHECK(p({Argument(1, 2), 1}) == p({{1, 2}, 1}));
    CHECK(Polynomial({1, 2, 3})[2] == 3);
    const BSplineCurve spline(1, {0, 0, 1, 1}, {{0}, {1}});
    CHECK(insert_knots(spline, {half}).control_points() == std::vector<Coordinates>{{0}, {half}, {1}});
}

TEST_CASE("the affine algebra of parameters and directions") {
    const Parameter a = 1;
    const Direction v{2};
    CHECK(a + v == Parameter(3));
    CHECK(v + a == Parameter(3));
    CHECK(a - v == Parameter(-1));
    CHECK(v - Direction{3} == -delta);
    CHECK(v * half == delta);
    CHECK(half * v == delta);
    CHECK(v / 2 == delta);
    CHECK(a < a + v);
    Parameter b = a;
    b += v;
    b -= delta;
    CHECK(b - a == delta);
}
