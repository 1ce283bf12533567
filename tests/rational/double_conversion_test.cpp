#include <blossom/rational/double_conversion.hpp>
#include "rational_test.hpp"

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace {

constexpr double smallest = std::numeric_limits<double>::denorm_min();

Rational power_of_two(int exponent) {
    const Integer power = Integer(1) << static_cast<std::size_t>(std::abs(exponent));
    return exponent < 0 ? Rational(1, power) : Rational(power);
}

/// Any finite double, with a uniformly distributed exponent.
double any_double(Random& random) {
    double value = std::bit_cast<double>(random.word());
    while (!std::isfinite(value)) value = std::bit_cast<double>(random.word());
    return value;
}

/// The least unit 2^e >= 2^-1074 with |value| < 2^53 units.
Rational unit_by_doubling(const Rational& value) {
    Rational unit = power_of_two(-1074);
    while (abs(value) >= unit * power_of_two(53 + 64)) unit = unit * power_of_two(64);
    while (abs(value) >= unit * power_of_two(53)) unit = unit + unit;
    return unit;
}

}  // namespace

TEST_CASE("a double is exactly the rational number that it is", "[double_conversion]") {
    CHECK(exact_rational(0.0) == 0);
    CHECK(exact_rational(-0.0) == 0);
    CHECK(exact_rational(1.0) == 1);
    CHECK(exact_rational(-0.75) == Rational(-3, 4));
    CHECK(to_string(exact_rational(0.1)) == "3602879701896397/36028797018963968");
    CHECK(exact_rational(smallest) == power_of_two(-1074));
    CHECK(exact_rational(DBL_MIN) == power_of_two(-1022));
    CHECK(exact_rational(DBL_MAX) == power_of_two(1024) - power_of_two(971));
    CHECK(exact_rational(0x1p63) == power_of_two(63));
    CHECK(exact_rational(-0x1p63) == INT64_MIN);
}

TEST_CASE("NaN and infinities are not numbers", "[double_conversion]") {
    for (const double value :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity()}) {
        CHECK(failure_code([&] { exact_rational(value); }) == ErrorCode::not_a_number);
    }
}

TEST_CASE("every double comes back as itself", "[double_conversion]") {
    Random random(71);
    for (int i = 0; i < 5000; ++i) {
        const double value = any_double(random);
        CAPTURE(value);
        CHECK(nearest_double(exact_rational(value)) == value);
        CHECK(std::strtod(hexadecimal_float(exact_rational(value)).c_str(), nullptr) == value);
    }
    for (const double value :
         {0.0, smallest, -smallest, DBL_MIN, std::nextafter(DBL_MIN, 0.0), DBL_MAX, -DBL_MAX, 1.0}) {
        CHECK(nearest_double(exact_rational(value)) == value);
    }
}

TEST_CASE("the nearest double of simple fractions", "[double_conversion]") {
    for (int p = -40; p <= 40; ++p) {
        for (int q = 1; q <= 40; ++q) {
            CAPTURE(p, q);
            // One division of two exact doubles is correctly rounded.
            CHECK(nearest_double(Rational(p, q)) == static_cast<double>(p) / q);
        }
    }
}

TEST_CASE("no double is nearer than the nearest", "[double_conversion]") {
    Random random(72);
    for (int i = 0; i < 4000; ++i) {
        Rational value = rational(random);
        const auto shift = static_cast<int>(random.between(-1100, 300));
        if (random.one_in(2)) value *= power_of_two(shift);
        CAPTURE(value);
        CHECK(textbook::is_nearest(nearest_double(value), value));
    }
}

TEST_CASE("rounding against strtod on exact decimals", "[double_conversion]") {
    Random random(73);
    for (int i = 0; i < 4000; ++i) {
        std::string digits;
        for (std::uint64_t k = 1 + random.below(random.one_in(10) ? 700 : 30); k > 0; --k) {
            digits += static_cast<char>('0' + random.below(10));
        }
        const auto exponent = random.between(-345, 308) - static_cast<std::int64_t>(digits.size());
        const std::string text = (random.one_in(2) ? "-" : "") + digits + "e" + std::to_string(exponent);
        CAPTURE(text);
        CHECK(nearest_double(parse_rational(text)) == std::strtod(text.c_str(), nullptr));
    }
}

TEST_CASE("halfway between two doubles the even significand wins, and a hair decides otherwise",
          "[double_conversion]") {
    Random random(74);
    for (int i = 0; i < 1500; ++i) {
        // significand * 2^exponent with 54 bits, the last one set: the midpoint of two doubles.
        const auto significand = static_cast<std::int64_t>((std::uint64_t{1} << 53) +
                                                           2 * random.below(std::uint64_t{1} << 52) + 1);
        const auto exponent = static_cast<int>(random.between(-1070, 960));
        const std::string text = textbook::decimal_of(significand, exponent);
        CAPTURE(significand, exponent);
        const Rational middle = Rational(significand) * power_of_two(exponent);
        CHECK(parse_rational(text) == middle);
        const double below = std::ldexp(static_cast<double>((significand - 1) / 2), exponent + 1);
        const double above = std::ldexp(static_cast<double>((significand + 1) / 2), exponent + 1);
        const bool lower_is_even = (significand - 1) / 2 % 2 == 0;
        CHECK(nearest_double(middle) == (lower_is_even ? below : above));
        CHECK(nearest_double(middle) == std::strtod(text.c_str(), nullptr));
        CHECK(nearest_double(-middle) == -(lower_is_even ? below : above));
        const Rational hair = power_of_two(exponent - 200);
        CHECK(nearest_double(middle - hair) == below);
        CHECK(nearest_double(middle + hair) == above);
    }
}

TEST_CASE("halfway between two subnormal doubles", "[double_conversion]") {
    for (const std::int64_t odd : {1, 3, 5, 7, 1001, 1003}) {
        const Rational middle = Rational(odd) * power_of_two(-1075);
        const auto even = static_cast<double>(odd % 4 == 1 ? odd / 2 : odd / 2 + 1);
        CAPTURE(odd);
        CHECK(nearest_double(middle) == even * smallest);
        CHECK(nearest_double(middle + power_of_two(-2000)) == static_cast<double>(odd / 2 + 1) * smallest);
        CHECK(nearest_double(middle - power_of_two(-2000)) == static_cast<double>(odd / 2) * smallest);
    }
}

TEST_CASE("the smallest subnormal, half of it, and the least normal", "[double_conversion]") {
    const Rational half = power_of_two(-1075);
    CHECK(nearest_double(power_of_two(-1074)) == smallest);
    CHECK(nearest_double(half) == 0.0);
    CHECK(nearest_double(-half) == 0.0);
    CHECK(nearest_double(half + power_of_two(-5000)) == smallest);
    CHECK(nearest_double(-half - power_of_two(-5000)) == -smallest);
    CHECK(nearest_double(power_of_two(-100'000)) == 0.0);
    // The greatest subnormal and the least normal meet without a gap.
    CHECK(nearest_double(power_of_two(-1022) - power_of_two(-1075)) == DBL_MIN);
    CHECK(nearest_double(power_of_two(-1022) - power_of_two(-1074)) == std::nextafter(DBL_MIN, 0.0));
    CHECK(nearest_double(power_of_two(-1022) - power_of_two(-1075) - power_of_two(-1200)) ==
          std::nextafter(DBL_MIN, 0.0));
}

TEST_CASE("the range of a double ends exactly at 2^1024 - 2^970", "[double_conversion]") {
    const Rational threshold = power_of_two(1024) - power_of_two(970);
    const Rational hair = power_of_two(-10);
    CHECK(nearest_double(power_of_two(1024) - power_of_two(971)) == DBL_MAX);
    CHECK(nearest_double(threshold - hair) == DBL_MAX);
    CHECK(nearest_double(hair - threshold) == -DBL_MAX);
    for (const Rational& value :
         {threshold, -threshold, threshold + hair, power_of_two(1024), power_of_two(100'000)}) {
        CHECK(failure_code([&] { nearest_double(value); }) == ErrorCode::overflow);
        CHECK(failure_code([&] { hexadecimal_float(value); }) == ErrorCode::overflow);
    }
}

TEST_CASE("hexadecimal floats as C writes them", "[double_conversion]") {
    CHECK(hexadecimal_float(0) == "0x0p+0");
    CHECK(hexadecimal_float(1) == "0x1p+0");
    CHECK(hexadecimal_float(-3) == "-0x1.8p+1");
    CHECK(hexadecimal_float(Rational(1, 10)) == "0x1.999999999999ap-4");
    CHECK(hexadecimal_float(Rational(-1, 3)) == "-0x1.5555555555555p-2");
    CHECK(hexadecimal_float(power_of_two(-1075)) == "0x0p+0");
    CHECK(hexadecimal_float(-power_of_two(-1075)) == "-0x0p+0");
    CHECK(hexadecimal_float(power_of_two(1024) - power_of_two(971)) == "0x1.fffffffffffffp+1023");
    Random random(75);
    for (int i = 0; i < 500; ++i) {
        const Rational value = rational(random);
        const double nearest = nearest_double(value);
        const std::string text = hexadecimal_float(value);
        CAPTURE(value, text);
        CHECK(std::strtod(text.c_str(), nullptr) == nearest);
        CHECK(text.substr(text.starts_with('-') ? 1 : 0, 2) == "0x");
    }
}

TEST_CASE("the unit in the last place is the distance between neighbouring doubles", "[double_conversion]") {
    const Rational epsilon = power_of_two(-52);
    CHECK(unit_in_last_place(1) == epsilon);
    CHECK(unit_in_last_place(Rational(-3, 2)) == epsilon);
    CHECK(unit_in_last_place(2) == 2 * epsilon);
    CHECK(unit_in_last_place(Rational(1, 3)) == epsilon / 4);
    CHECK(unit_in_last_place(0) == power_of_two(-1074));
    CHECK(unit_in_last_place(parse_rational("1e-400")) == power_of_two(-1074));
    CHECK(unit_in_last_place(1 - parse_rational("1e-24")) == epsilon / 2);
    CHECK(unit_in_last_place(power_of_two(1024) - power_of_two(971)) == power_of_two(971));
    CHECK(unit_in_last_place(power_of_two(1024) - power_of_two(-10)) == power_of_two(971));
    for (const Rational& value : {power_of_two(1024), -power_of_two(1024), power_of_two(100'000)}) {
        CHECK(failure_code([&] { unit_in_last_place(value); }) == ErrorCode::overflow);
    }
}

TEST_CASE("the unit in the last place changes exactly at the powers of two", "[double_conversion]") {
    Random random(76);
    for (int exponent = -1090; exponent < 1024; exponent += random.one_in(3) ? 1 : 7) {
        const Rational power = power_of_two(exponent);
        for (const int nearness : {-1, -52, -53, -54, -80, -2000}) {
            const Rational hair = power_of_two(exponent + nearness);
            CAPTURE(exponent, nearness);
            for (const Rational& value : {power, power - hair, power + hair}) {
                CHECK(unit_in_last_place(value) == unit_by_doubling(value));
                CHECK(unit_in_last_place(-value) == unit_in_last_place(value));
            }
        }
    }
    for (const int exponent : {-1075, -1074, -1073, -1023, -1022, -1021, -1, 0, 1, 1022, 1023}) {
        const Rational power = power_of_two(exponent);
        CAPTURE(exponent);
        CHECK(unit_in_last_place(power) == unit_by_doubling(power));
        CHECK(unit_in_last_place(power - power_of_two(exponent - 60)) ==
              unit_by_doubling(power - power_of_two(exponent - 60)));
    }
}

TEST_CASE("the nearest double of a number too small for any is a zero of its sign", "[double_conversion]") {
    for (const Rational& tiny : {power_of_two(-1075), power_of_two(-1076), power_of_two(-100'000)}) {
        CHECK(nearest_double(tiny) == 0.0);
        CHECK_FALSE(std::signbit(nearest_double(tiny)));
        CHECK(std::signbit(nearest_double(-tiny)));
        CHECK(hexadecimal_float(tiny) == "0x0p+0");
        CHECK(hexadecimal_float(-tiny) == "-0x0p+0");
    }
    CHECK_FALSE(std::signbit(nearest_double(0)));
}
