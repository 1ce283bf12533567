#include "rational_test.hpp"

// The generators must produce every corner case, with the frequencies that their header states.

TEST_CASE("the stream of choices is the same everywhere", "[generators]") {
    // The 10000th output of std::mt19937_64 with its default seed is fixed by the standard.
    Random random(5489);
    for (int i = 1; i < 10000; ++i) random.word();
    CHECK(random.word() == 9981545732273789042U);
}

TEST_CASE("choices below a bound are uniform and reach both ends", "[generators]") {
    Random random(1);
    std::map<std::int64_t, int> counts;
    for (int i = 0; i < 7000; ++i) ++counts[random.between(-3, 3)];
    REQUIRE(counts.size() == 7);
    CHECK(counts.begin()->first == -3);
    CHECK(counts.rbegin()->first == 3);
    for (const auto& [value, count] : counts) {
        CAPTURE(value);
        CHECK(count > 850);
        CHECK(count < 1150);
    }
    bool negative = false;
    bool positive = false;
    for (int i = 0; i < 100; ++i) {
        const std::int64_t any = random.between(INT64_MIN, INT64_MAX);
        negative |= any < INT64_MIN / 2;
        positive |= any > INT64_MAX / 2;
    }
    CHECK(negative);
    CHECK(positive);
}

TEST_CASE("integers reach every corner in the shares claimed", "[generators]") {
    constexpr int samples = 32000;
    Random random(2);
    std::map<std::string, int> corners;
    int units = 0;
    int tiny = 0;
    int words = 0;
    int huge = 0;
    for (int i = 0; i < samples; ++i) {
        const Integer value = integer(random);
        const Integer magnitude = abs(value);
        units += magnitude <= Integer(1);
        tiny += magnitude <= Integer(100);
        words += value.to_int64().has_value();
        huge += value.bit_length() > 130;
        for (const std::size_t exponent : boundary_exponents) {
            for (int offset = -2; offset <= 2; ++offset) {
                for (const int sign : {-1, 1}) {
                    if (value == Integer(sign) * (Integer(1) << exponent) + Integer(offset)) {
                        ++corners[std::to_string(sign) + " 2^" + std::to_string(exponent) + " " +
                                  std::to_string(offset)];
                    }
                }
            }
        }
    }
    const auto share = [](int count) { return 16.0 * count / samples; };
    CHECK(share(units) > 2.9);
    CHECK(share(units) < 3.4);
    CHECK(share(tiny) > 6.7);
    CHECK(share(tiny) < 7.3);
    CHECK(share(words) > 10);
    CHECK(share(words) < 13);
    CHECK(share(huge) > 1.6);
    CHECK(share(huge) < 2.2);
    CHECK(corners.size() == 40);
    for (const auto& [corner, count] : corners) {
        CAPTURE(corner);
        CHECK(count > 120);
        CHECK(count < 290);
    }
}

TEST_CASE("integers of a number of bits have that number of bits and both signs", "[generators]") {
    Random random(3);
    int negative = 0;
    for (std::size_t bits = 0; bits <= 200; ++bits) {
        const Integer value = integer_of_bits(random, bits);
        CHECK(value.bit_length() == bits);
        negative += value.sign() < 0;
    }
    CHECK(negative > 60);
    CHECK(negative < 140);
}

TEST_CASE("rational numbers are small, whole and huge", "[generators]") {
    constexpr int samples = 4000;
    Random random(4);
    int zero = 0;
    int whole = 0;
    int huge_denominator = 0;
    int negative = 0;
    for (int i = 0; i < samples; ++i) {
        const Rational value = rational(random);
        zero += value.is_zero();
        whole += value.is_integer();
        huge_denominator += value.denominator().bit_length() > 64;
        negative += value.sign() < 0;
    }
    CHECK(zero > samples / 25);
    CHECK(whole > samples / 3);
    CHECK(whole < samples * 3 / 4);
    CHECK(huge_denominator > samples / 25);
    CHECK(negative > samples / 3);
}
