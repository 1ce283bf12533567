#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/polynomial_curve.hpp>
#include "core_test.hpp"

#include <type_traits>

// The types from which maps are made: arguments, intervals, arrays of points, curves.

namespace {

template <class A, class B>
concept Addable = requires(const A& a, const B& b) { a + b; };

}  // namespace

static_assert(!Addable<Parameter, Parameter>);
static_assert(Addable<Parameter, Direction>);
static_assert(Addable<Direction, Direction>);
static_assert(!std::is_convertible_v<Direction, Parameter>);
static_assert(!std::is_convertible_v<Parameter, Direction>);
static_assert(!std::is_constructible_v<Parameter, double>);

TEST_CASE("points have mass 1, vectors mass 0, and their differences are exact", "[curves]") {
    CHECK(Argument(Parameter(Rational(1, 2))) == Argument(Rational(1, 2), 1));
    CHECK(Argument(Direction{3}) == Argument(3, 0));
    CHECK(Argument(delta) == Argument(1, 0));
    const Parameter a(Rational(1, 3));
    const Parameter b(2);
    CHECK((b - a) == Direction{Rational(5, 3)});
    CHECK((a + (b - a)) == b);
    CHECK(((b - a) + (a - b)) == Direction{0});
    CHECK((Rational(3, 5) * (b - a)) == Direction{1});
    const std::vector<Argument> list = with_copies(with_copies({}, 2, a), 1, delta);
    CHECK(list == std::vector<Argument>{a, a, delta});
    CHECK(with_copies({}, 0, delta).empty());
}

TEST_CASE("an interval has two different ends", "[curves]") {
    CHECK(Interval() == Interval(0, 1));
    CHECK(Interval(1, 0).a() == 1);
    CHECK_FALSE(Interval(1, 0) == Interval(0, 1));
    CHECK(failure_code([] { Interval(Rational(1, 2), Rational(2, 4)); }) == ErrorCode::empty_interval);
}

TEST_CASE("an array of points has one dimension", "[curves]") {
    const std::vector<Coordinates> points{{1, Rational(1, 2)}, {Rational(1, 3), 0}};
    const PointArray array(points);
    CHECK(array.size() == 2);
    CHECK(array.dimension() == 2);
    CHECK(array.to_points() == points);
    CHECK(array[1] == points[1]);
    CHECK(array.denominator() == 6);
    CHECK(array.rows().size() == 2);
    CHECK(array.coordinate(1)[0] == 3);

    const std::vector<Coordinates> uneven{{1, 2}, {1, 2}, {1}};
    const auto error = failure([&] { PointArray array_of_uneven(uneven); });
    REQUIRE(error);
    CHECK(error->code() == ErrorCode::mismatched_dimensions);
    CHECK(error->place() == Place{std::size_t{2}});
    const std::vector<Coordinates> flat{{}, {}};
    CHECK(failure_code([&] { PointArray array_of_flat(flat); }) == ErrorCode::mismatched_dimensions);
    CHECK(failure_code([] { PointArray array_of_none(std::span<const Coordinates>{}); }) ==
          ErrorCode::wrong_arity);
}

TEST_CASE("arrays of points are equal as points and canonical on demand", "[curves]") {
    Random random(141);
    for (int i = 0; i < 500; ++i) {
        const PolynomialRecipe recipe = polynomial_map(random, 3, Size::any);
        PointArray array(recipe.coefficients);
        CHECK(array.to_points() == recipe.coefficients);
        std::vector<Integer> numerators = array.numbers().numerators();
        for (Integer& numerator : numerators) numerator *= -6;
        PointArray scaled(array.dimension(), RationalVector(numerators, array.denominator() * -6));
        CHECK(scaled == array);
        scaled.make_canonical();
        array.make_canonical();
        CHECK(scaled.denominator() == array.denominator());
    }
}

TEST_CASE("the formal degree of a map is part of it", "[curves]") {
    const Polynomial t = Polynomial::monomial(1);
    CHECK(PolynomialCurve(t).degree() == 1);
    CHECK(PolynomialCurve(t, 2).degree() == 2);
    CHECK(PolynomialCurve(t, 2).actual_degree() == 1);
    CHECK_FALSE(PolynomialCurve(t, 2) == PolynomialCurve(t, 1));
    CHECK(PolynomialCurve(Polynomial()).degree() == 0);
    CHECK(PolynomialCurve(Polynomial(), 5).actual_degree() == 0);
    CHECK(failure_code([&] { PolynomialCurve(t * t, 1); }) == ErrorCode::degree_too_low);

    const std::vector<Coordinates> padded{{1}, {2}, {0}, {0}};
    CHECK(PolynomialCurve(padded).degree() == 3);
    CHECK(PolynomialCurve(padded, 1).degree() == 1);
    CHECK(PolynomialCurve(padded, 1) == PolynomialCurve(t * 2 + 1));
    CHECK(PolynomialCurve(padded, 7).degree() == 7);
    CHECK(failure_code([&] { PolynomialCurve(padded, 0); }) == ErrorCode::degree_too_low);
    CHECK(failure_code([] { PolynomialCurve(std::span<const Coordinates>{}); }) == ErrorCode::wrong_arity);
    CHECK(failure_code([] { PolynomialCurve(std::span<const Polynomial>{}); }) == ErrorCode::wrong_arity);
}

TEST_CASE("a map from its coordinates is the map from its points", "[curves]") {
    Random random(142);
    for (int i = 0; i < 400; ++i) {
        const PolynomialRecipe recipe = polynomial_map(random, 4, Size::any);
        const PolynomialCurve curve = recipe.curve();
        std::vector<Polynomial> coordinates;
        for (std::size_t j = 0; j < curve.dimension(); ++j) {
            coordinates.push_back(curve.coordinate(j));
            for (std::size_t k = 0; k <= 4; ++k) {
                const Rational expected =
                    k < recipe.coefficients.size() ? recipe.coefficients[k][j] : Rational();
                CHECK(curve.coordinate(j)[k] == expected);
            }
        }
        CHECK(PolynomialCurve(coordinates, 4) == curve);
        CHECK(PolynomialCurve(coordinates).degree() == curve.actual_degree());
    }
}

TEST_CASE("a control polygon names the point that does not fit", "[curves]") {
    const std::vector<Coordinates> uneven{{1, 2}, {1}};
    const auto error = failure([&] { BezierCurve curve(uneven); });
    REQUIRE(error);
    CHECK(error->code() == ErrorCode::mismatched_dimensions);
    CHECK(error->place() == Part::control_points / 1);
    const std::vector<Coordinates> points{{1, 2}, {3, 4}, {5, 6}};
    CHECK(BezierCurve(points).degree() == 2);
    CHECK(BezierCurve(points).dimension() == 2);
    CHECK(BezierCurve(points) == BezierCurve(points, Interval(0, 1)));
    CHECK_FALSE(BezierCurve(points) == BezierCurve(points, Interval(1, 0)));
}
