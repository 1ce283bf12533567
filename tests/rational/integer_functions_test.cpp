#include "rational_test.hpp"

TEST_CASE("greatest common divisors and least common multiples", "[integer]") {
    Random random(31);
    for (int i = 0; i < 3000; ++i) {
        // Multiples of a shared factor, since random integers of many digits are nearly always coprime.
        const Integer factor = integer(random);
        const Integer a = integer(random) * factor;
        const Integer b = integer(random) * factor;
        CAPTURE(a, b);
        CHECK(to_string(gcd(a, b)) == textbook::greatest_common_divisor(a, b));
        CHECK(to_string(lcm(a, b)) == textbook::least_common_multiple(a, b));
    }
    CHECK(gcd(0, 0) == 0);
    CHECK(lcm(0, 5) == 0);
    CHECK(gcd(0, -5) == 5);
    CHECK(gcd(-4, 6) == 2);
    CHECK(lcm(-4, 6) == 12);
}

TEST_CASE("powers of integers", "[integer]") {
    Random random(32);
    for (int i = 0; i < 400; ++i) {
        const Integer base = integer(random);
        const auto exponent = static_cast<unsigned>(random.below(12));
        CAPTURE(base, exponent);
        CHECK(to_string(pow(base, exponent)) == textbook::power(base, exponent));
    }
    CHECK(pow(Integer(0), 0) == 1);
    CHECK(pow(Integer(0), 5) == 0);
    CHECK(pow(Integer(-1), 1'000'001) == -1);
    CHECK(pow(Integer(-2), 63) == INT64_MIN);
    CHECK(pow(Integer(2), 63) == -Integer(INT64_MIN));
}

TEST_CASE("the dot product is the sum of the products", "[integer]") {
    Random random(34);
    for (int i = 0; i < 300; ++i) {
        std::vector<Integer> a;
        std::vector<Integer> b;
        Integer expected;
        for (std::uint64_t k = random.below(8); k > 0; --k) {
            a.push_back(integer(random));
            b.push_back(integer(random));
            expected = expected + a.back() * b.back();
        }
        CHECK(dot(a, b) == expected);
    }
    CHECK(dot({}, {}) == 0);
}

TEST_CASE("integers as words in two's complement", "[integer]") {
    constexpr std::uint64_t ones = ~std::uint64_t{0};
    const std::pair<Integer, std::vector<std::uint64_t>> cases[] = {
        {0, {0}},
        {-1, {ones, ones}},
        {INT64_MIN, {std::uint64_t{1} << 63}},
        {pow(Integer(2), 64), {0, 1}},
        {-pow(Integer(2), 64), {0, ones}},
        {pow(Integer(2), 64) + 5, {5, 1, 0}},
        {-pow(Integer(2), 127), {0, std::uint64_t{1} << 63}},
    };
    for (const auto& [value, words] : cases) {
        CHECK(from_twos_complement(words) == value);
        std::vector<std::uint64_t> written(words.size(), 7);
        to_twos_complement(value, written);
        CHECK(written == words);
    }
}
