#include "rational_test.hpp"
#include <blossom/rational/rational.hpp>

#include <type_traits>

static_assert(!std::is_constructible_v<Rational, double>);
static_assert(!std::is_constructible_v<Rational, float>);
static_assert(!std::is_constructible_v<Rational, bool>);
static_assert(!std::is_constructible_v<Rational, const char*>);
static_assert(!std::is_constructible_v<Rational, std::string>);

namespace {

void check_lowest_terms(const Rational& value) {
    CHECK(value.denominator().sign() == 1);
    CHECK(textbook::greatest_common_divisor(value.numerator(), value.denominator()) == "1");
    if (value.is_zero()) CHECK(value.denominator() == 1);
}

}  // namespace

TEST_CASE("rational operations against another library", "[rational]") {
    Random random(41);
    for (int i = 0; i < 4000; ++i) {
        const Rational a = rational(random);
        const Rational b = rational(random);
        CAPTURE(a, b);
        CHECK(to_string(a + b) == textbook::sum(a, b));
        CHECK(to_string(a - b) == textbook::difference(a, b));
        CHECK(to_string(a * b) == textbook::product(a, b));
        if (!b.is_zero()) CHECK(to_string(a / b) == textbook::quotient(a, b));
        CHECK((a <=> b) == (textbook::comparison(a, b) <=> 0));
        CHECK((a == b) == (textbook::comparison(a, b) == 0));
        check_lowest_terms(a + b);
        check_lowest_terms(a - b);
        check_lowest_terms(a * b);
        check_lowest_terms(-a);
    }
}

TEST_CASE("sums whose denominators share factors come out reduced", "[rational]") {
    for (int p = -6; p <= 6; ++p) {
        for (int q = 1; q <= 12; ++q) {
            for (int r = -6; r <= 6; ++r) {
                for (int s = 1; s <= 12; ++s) {
                    const Rational a(p, q);
                    const Rational b(r, s);
                    const Rational sum = a + b;
                    CHECK(sum.numerator() * Integer(q * s) == Integer(p * s + r * q) * sum.denominator());
                    check_lowest_terms(sum);
                }
            }
        }
    }
}

TEST_CASE("a quotient of integers of any sign is reduced with a positive denominator", "[rational]") {
    Random random(42);
    for (int i = 0; i < 3000; ++i) {
        const Integer factor = integer(random);
        const Integer p = integer(random) * factor;
        const Integer q = integer(random) * factor;
        CAPTURE(p, q);
        if (q.is_zero()) {
            CHECK(failure_code([&] { Rational(p, q); }) == ErrorCode::zero_denominator);
            continue;
        }
        const Rational value(p, q);
        CHECK(to_string(value) == textbook::lowest_terms(p, q));
        check_lowest_terms(value);
    }
    CHECK(to_string(Rational(1, -2)) == "-1/2");
    CHECK(to_string(Rational(1, -5)) == "-1/5");
    CHECK(to_string(Rational(-6, -4)) == "3/2");
    CHECK(to_string(Rational(0, -7)) == "0");
    CHECK(to_string(Rational(INT64_MIN, INT64_MIN)) == "1");
    CHECK(to_string(Rational(1, INT64_MIN)) == "-1/9223372036854775808");
}

TEST_CASE("equal rational numbers hash equal however they were reached", "[rational]") {
    const std::hash<Rational> hash;
    CHECK(hash(Rational(2, 4)) == hash(Rational(1, 2)));
    CHECK(hash(Rational(3, -6)) == hash(-Rational(1, 2)));
    CHECK(hash(Rational(1, 3) + Rational(1, 6)) == hash(Rational(1, 2)));
    CHECK(hash(Rational(1, 2)) != hash(Rational(2)));
    CHECK(hash(Rational(1, 2)) != hash(Rational(1, 3)));
}

TEST_CASE("a rational number may be its own operand", "[rational]") {
    Random random(43);
    for (int i = 0; i < 1000; ++i) {
        const Rational value = rational(random);
        CAPTURE(value);
        Rational self = value;
        self += self;
        CHECK(self == value * 2);
        self = value;
        self -= self;
        CHECK(to_string(self) == "0");
        check_lowest_terms(self);
        self = value;
        self *= self;
        CHECK(self == pow(value, 2));
        if (value.is_zero()) continue;
        self = value;
        self /= self;
        CHECK(to_string(self) == "1");
        self = value;
        const Rational& alias = self;
        self = alias;
        CHECK(self == value);
    }
}

TEST_CASE("rational division by zero is an error", "[rational]") {
    CHECK(failure_code([] { return Rational(1) / Rational(0); }) == ErrorCode::division_by_zero);
    CHECK(failure_code([] { return Rational(0) / Rational(0); }) == ErrorCode::division_by_zero);
    CHECK(failure_code([] { return Rational(5, 0); }) == ErrorCode::zero_denominator);
    CHECK(Rational(3) / Rational(-2, 5) == Rational(-15, 2));
}

TEST_CASE("powers, absolute values and signs of rational numbers", "[rational]") {
    Random random(44);
    for (int i = 0; i < 500; ++i) {
        const Rational base = rational(random);
        const auto exponent = static_cast<unsigned>(random.below(8));
        CAPTURE(base, exponent);
        CHECK(to_string(pow(base, exponent)) == textbook::power(base, exponent));
        CHECK(abs(base) == (base < Rational(0) ? -base : base));
        CHECK(base.sign() == textbook::comparison(base, 0));
        CHECK(base.is_zero() == (to_string(base) == "0"));
        CHECK(base.is_integer() == (to_string(base).find('/') == std::string::npos));
    }
    CHECK(pow(Rational(0), 0) == 1);
}
