// The matchers for the tests of other programs, with Catch2 and with GoogleTest.

#include <blossom/rational/rational.hpp>
#include <blossom/testing/catch2.hpp>
#include <blossom/testing/gtest.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/catch.hpp"

using namespace blossom;

TEST_CASE("ulps are those of the exact number") {
    CHECK(ulps(1.0, 1) == 0);
    CHECK(ulps(std::nextafter(1.0, 2), 1) == 1);
    CHECK(ulps(std::nextafter(1.0, 0), 1) == Rational(1, 2));
    const Rational below_1 = 1 - pow(Rational(10), -24);
    CHECK(ulps(std::nextafter(1.0, 0), below_1) == 1 - pow(Rational(10), -24) * pow(Rational(2), 53));
    CHECK(ulps(0.1, Rational(1, 10)) < Rational(1, 2));
    CHECK(ulps(5e-324, 0) == 1);
}

TEST_CASE("the matchers of Catch2") {
    const Rational third(1, 3);
    const double next = std::nextafter(1.0 / 3, 1);
    CHECK_THAT(1.0 / 3, IsWithinUlps(third, Rational(1, 2)));
    CHECK_THAT(next, IsWithinUlps(third, 1));
    CHECK_THAT(next, !IsWithinUlps(third, Rational(1, 2)));
    CHECK_THAT(std::numeric_limits<double>::quiet_NaN(), !IsWithinUlps(third, 1000));
    CHECK_THAT(std::numeric_limits<double>::infinity(), !IsWithinUlps(third, 1000));
    CHECK_THAT((std::vector{0.5, 1.0 / 3}), PointIsWithinUlps({Rational(1, 2), third}, Rational(1, 2)));
    CHECK_THAT((std::vector{0.5, next}), !PointIsWithinUlps({Rational(1, 2), third}, Rational(1, 2)));
    CHECK_THAT((std::vector{next, 0.5}), !PointIsWithinUlps({third, Rational(1, 2)}, Rational(1, 2)));
    CHECK_THAT((std::vector{0.5}), !PointIsWithinUlps({Rational(1, 2), third}, 1));

    const IsWithinUlps matcher(third, Rational(1, 2));
    CHECK_FALSE(matcher.match(next));
    CHECK(matcher.describe() ==
          "\n0x1.5555555555556p-2 is at least 0.666 ulp from 1/3 (nearest double "
          "0x1.5555555555555p-2); at most 1/2 are allowed");
}

TEST_CASE("a distance beyond the doubles is reported") {
    const IsWithinUlps matcher(0, 1);
    CHECK_FALSE(matcher.match(std::numeric_limits<double>::max()));
    CHECK(matcher.describe().find(" ulp from 0 (nearest double 0x0p+0)") != std::string::npos);
}

TEST_CASE("the assertions of GoogleTest") {
    const Rational third(1, 3);
    CHECK(WithinUlps(1.0 / 3, third, 1));
    CHECK_FALSE(WithinUlps(0.25, third, 1));
    const std::vector<double> computed{0.5, 1.0 / 3};
    CHECK(WithinUlps(computed, std::vector{Rational(1, 2), third}, 1));
    CHECK_FALSE(WithinUlps(computed, std::vector{third, third}, 1));
}
