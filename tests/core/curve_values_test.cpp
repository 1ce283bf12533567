#include <blossom/core/spline/curve_values.hpp>
#include <blossom/rational/resource_budget.hpp>
#include "core_test.hpp"

// Curves prepared for evaluation at many parameters, compared with Horner's rule and de Boor's triangle on
// integers.

namespace {

Size any_size(Random& random) { return random.one_in(3) ? Size::any : Size::small; }

/// Compares all values of one batch with single values, and these with `expected`.
template <class Values, class Expected>
void check(Random& random, const Values& values, std::span<const Rational> parameters,
           const Expected& expected) {
    const std::vector<Rational> batch = values.at(parameters, 1 + random.below(3));
    REQUIRE(batch.size() == parameters.size() * values.dimension());
    // Writes to memory that already holds numbers of any size.
    std::vector<Rational> results(batch.size());
    for (Rational& result : results) result = number(random, any_size(random));
    values.at(parameters, results, 1 + random.below(3));
    CHECK(results == batch);
    results.emplace_back();
    CHECK(failure_code([&] { values.at(parameters, results); }) == ErrorCode::mismatched_dimensions);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        CAPTURE(i, parameters[i]);
        const Coordinates value = expected(parameters[i]);
        CHECK(values(parameters[i]) == value);
        const auto place = batch.begin() + static_cast<std::ptrdiff_t>(i * values.dimension());
        CHECK(std::equal(value.begin(), value.end(), place));
    }
}

template <class Curve>
void check_curve(Random& random, const Curve& curve) {
    std::vector<Rational> parameters;
    for (std::size_t i = random.below(20); i > 0; --i) parameters.push_back(number(random, any_size(random)));
    check(random, CurveValues(curve), parameters, [&](const Rational& t) { return evaluate(curve, t); });
}

}  // namespace

TEST_CASE("curves are evaluated at many parameters", "[curve_values]") {
    Random random(1);
    for (int i = 0; i < 500; ++i) {
        check_curve(random, polynomial_map(random, random.below(9), any_size(random)).curve());
        check_curve(random, bezier_map(random, random.below(9), any_size(random)).curve());
    }
}

TEST_CASE("splines are evaluated at many parameters", "[curve_values]") {
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const BSplineCurve curve = spline(random, random.below(7), any_size(random)).curve();
        std::vector<Rational> parameters;
        for (std::size_t j = random.below(20); j > 0; --j)
            parameters.push_back(parameter(random, curve.knots()));
        check(random, SplineValues(curve), parameters, [&](const Rational& t) { return de_boor(curve, t); });
    }
}

TEST_CASE("splines whose knots are at the limits of a word", "[curve_values]") {
    Random random(3);
    for (const unsigned bits : {61U, 62U, 63U, 64U, 70U}) {
        for (const int sign : {-1, 1}) {
            const Integer far = sign * (Integer(1) << bits);
            for (const Rational& scale : {Rational(1), Rational(1, 3), Rational(5, (Integer(1) << 40) + 1)}) {
                std::vector<Rational> knots;
                for (int i = 0; i < 8; ++i) knots.push_back(Rational(far) - 4 * sign + i * scale);
                const BSplineCurve curve(2, knots, {{0, 1}, {2, 3}, {5, -1}, {0, 0}, {7, 7}});
                std::vector<Rational> parameters{curve.knots().domain().a(), curve.knots().domain().b()};
                for (int i = 0; i < 8; ++i) parameters.push_back(parameter(random, curve.knots()));
                check(random, SplineValues(curve), parameters,
                      [&](const Rational& t) { return de_boor(curve, t); });
            }
        }
    }
}

TEST_CASE("splines over few and over many integers", "[curve_values]") {
    Random random(4);
    for (const std::int64_t length : {3, 1023, 1024, 1025, 5000}) {
        for (const std::int64_t begin :
             {std::int64_t{-5000}, std::int64_t{-2}, std::int64_t{0}, INT64_MAX - 9000}) {
            for (const Rational& scale : {Rational(1), Rational(1, 6)}) {
                std::vector<Rational> knots;
                for (const std::int64_t place : {std::int64_t{-1}, std::int64_t{0}, std::int64_t{0},
                                                 length / 3, length / 3, length / 2, length, length + 2})
                    knots.push_back(scale * (begin + place));
                const BSplineCurve curve(2, knots, {{1}, {-2}, {5}, {0}, {7}});
                std::vector<Rational> parameters{curve.knots().domain().a(), curve.knots().domain().b()};
                for (int i = 0; i < 20; ++i) parameters.push_back(parameter(random, curve.knots()));
                for (const Rational& knot : curve.knots().knots())
                    if (knot >= curve.knots().domain().a() && knot <= curve.knots().domain().b())
                        parameters.push_back(knot);
                check(random, SplineValues(curve), parameters,
                      [&](const Rational& t) { return de_boor(curve, t); });
            }
        }
    }
}

TEST_CASE("a preparation that failed for lack of resources is repeated by the next caller",
          "[curve_values]") {
    Limits little;
    little.work = 1;
    const auto check = [&](const auto& values, const Rational& t, const Rational& expected) {
        {
            const ResourceBudget budget(little);
            CHECK(failure_code([&] { values(t); }) == ErrorCode::limit_exceeded);
        }
        CHECK(values(t) == Coordinates{expected});
    };
    const Rational large = Rational(1, pow(Integer(3), 100));
    check(SplineValues(BSplineCurve(1, {0, 0, 1, 1}, {{0}, {large}})), Rational(1, 2), large / 2);
    check(CurveValues(PolynomialCurve(Polynomial::monomial(40))), large, pow(large, 40));
}

TEST_CASE("prepared curves keep to the domain and to the limits", "[curve_values]") {
    const BSplineCurve spline(1, {0, 0, 1, 1}, {{0}, {1}});
    const SplineValues values(spline);
    CHECK(failure_code([&] { values(Rational(-1, 7)); }) == ErrorCode::outside_domain);
    CHECK(failure_code([&] { values.at(std::vector<Rational>{0, 2}); }) == ErrorCode::outside_domain);
    CHECK(values(1) == Coordinates{1});

    Limits limits;
    limits.digits = 60;
    const CurveValues power(PolynomialCurve(Polynomial::monomial(20)), limits);
    CHECK(power(100) == Coordinates{pow(Rational(100), 20)});
    CHECK(failure_code([&] { power(1'000'000); }) == ErrorCode::limit_exceeded);
    CHECK(failure_code([&] { power(Rational(1, Integer(1) << 70)); }) == ErrorCode::limit_exceeded);
    CHECK(power.at({}).empty());
}
