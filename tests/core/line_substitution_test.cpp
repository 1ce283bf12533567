#include <blossom/core/blossom/change_of_basis.hpp>
#include <blossom/core/maps/taylor_curve.hpp>
#include "core_test.hpp"

// Control points and Taylor coefficients by shifts on digits, compared with the recurrences on integers in
// their general form.

namespace {

/// The fractions u/q and w/q.
struct OverOne {
    Integer u;
    Integer w;
    Integer q;
};

OverOne over_one(const Rational& a, const Rational& b) {
    const Integer q = lcm(a.denominator(), b.denominator());
    return {(a * q).numerator(), (b * q).numerator(), q};
}

void check_conversions(const PolynomialCurve& curve, const Interval& over) {
    const RationalVector& numbers = curve.coefficients().numbers();
    const std::span<const Integer> row = curve.coefficients().coordinate(0);
    const auto [a, b, q] = over_one(over.a(), over.b());
    const Quotients<Integer> points = constructions::bernstein_from_monomial(row, a, b, q);
    CHECK(control_points(curve, over).control_points().numbers() ==
          RationalVector(points.numerators, points.denominator * numbers.denominator()));

    const Integer& p = over.a().numerator();
    const Integer& r = over.a().denominator();
    CHECK(taylor_form(curve, over.a()).coefficients.numbers() ==
          RationalVector(constructions::substitute_line(row, p, r, r),
                         pow(r, curve.degree()) * numbers.denominator()));
}

}  // namespace

TEST_CASE("control points and Taylor coefficients of any degree are those of the recurrences",
          "[conversion]") {
    Random random(1);
    for (int i = 0; i < 3000; ++i) {
        const Size size = random.one_in(8) ? Size::any : Size::small;
        std::vector<Coordinates> coefficients(1 + random.below(i % 16 == 0 ? 60 : 20));
        for (Coordinates& coefficient : coefficients)
            coefficient = {random.one_in(5) ? Rational() : number(random, size)};
        check_conversions(PolynomialCurve(coefficients), interval(random, size));
    }
}

TEST_CASE("control points of high degree are those of the recurrences", "[conversion]") {
    Random random(3);
    const Integer word = Integer(1) << 48;
    const Rational ends[] = {0,
                             Rational(-5, 6),
                             Rational(7, 12),
                             Rational(1 - word, 3),
                             Rational(word, 3),
                             Rational(2, word - 1),
                             Rational(2, word + 1)};
    for (const std::size_t n : {31U, 32U, 62U, 63U, 64U, 100U}) {
        std::vector<Coordinates> coefficients(n + 1);
        for (Coordinates& coefficient : coefficients) coefficient = {number(random, Size::small)};
        const PolynomialCurve curve(coefficients);
        for (std::size_t i = 0; i < std::size(ends); ++i) {
            check_conversions(curve, Interval(ends[i], ends[(i + 1) % std::size(ends)]));
            check_conversions(curve, interval(random, Size::small));
        }
    }
}

TEST_CASE("control points over intervals whose ends share denominators or are 0", "[conversion]") {
    Random random(2);
    const Rational ends[] = {0, 1, -1, Rational(1, 6), Rational(-5, 6), Rational(7, 12), Rational(3, 35), 10};
    for (const Rational& a : ends) {
        for (const Rational& b : ends) {
            if (a == b) continue;
            for (const std::size_t n : {0U, 1U, 5U, 13U, 30U}) {
                std::vector<Coordinates> coefficients(n + 1);
                for (Coordinates& coefficient : coefficients) coefficient = {number(random, Size::small)};
                check_conversions(PolynomialCurve(coefficients), Interval(a, b));
            }
        }
    }
}
