// Sums by residues: at high degree against the product at points, where the evident formula takes long.

#include "blossom_sums_cases.hpp"

#include <algorithm>
#include <thread>

using namespace blossom;
using namespace blossom::testing;

TEST_CASE("sums by residues", "[blossom_sums]") {
    Random random(7);
    Met met;
    for (int i = 0; i < 120; ++i) {
        const std::size_t n = 16 + random.below(i % 10 == 0 ? 80 : 20);
        check(random_case(random, n, 60 + random.below(900), 40 + random.below(22)), met);
    }
    CHECK(met[SumKernel::residues] > 80);
}

// With numbers w t^k the sum is w times the product of the factors at t.
TEST_CASE("sums by residues of high degree", "[blossom_sums]") {
    Random random(11);
    int different_from_zero = 0;
    // Where transforms begin, where they grow, and where each leaf of one is full.
    const std::size_t limits[] = {499, 500, 511, 512, 639, 640, 992, 993, 1008, 1009, 1279, 1280, 2016, 4032};
    for (std::size_t i = 0; i < 120; ++i) {
        const std::size_t n = i < 100   ? 16 + random.below(i % 4 == 0 ? 300 : 120)
                              : i < 114 ? limits[i - 100]
                                        : 500 + random.below(900);
        const std::size_t bits = i < 100 ? 2 + random.below(61) : 2 + random.below(7);
        const bool wide = i < 100 && random.one_in(4);
        const Rational points[] = {{random.between(-3, 3), n > 1500 ? 1 : random.between(1, 2)},
                                   {random.between(-3, 3), 1}};
        const auto numerator_at = [](const IntegerFactor& factor, const Rational& t) {
            return factor.constant * t.denominator() + factor.slope * t.numerator();
        };
        std::vector<WordFactor> factors;
        std::vector<IntegerFactor> wide_factors;
        while (factors.size() < n) {
            const WordFactor factor{word_of_bits(random, bits), word_of_bits(random, bits),
                                    denominator_of_bits(random, bits)};
            IntegerFactor wide_factor{factor.constant, factor.slope, factor.denominator};
            if (wide) wide_factor.slope = integer_of_bits(random, random.below(300));
            // One factor with a root there would make the sum 0.
            if (std::ranges::any_of(
                    points, [&](const Rational& t) { return numerator_at(wide_factor, t).is_zero(); }))
                continue;
            factors.push_back(factor);
            wide_factors.push_back(wide_factor);
        }
        std::vector<Rational> numbers(n + 1);
        Rational expected;
        for (const Rational& t : points) {
            const Rational weight(random.between(1, 9), random.between(1, 9));
            Rational power = 1;
            for (Rational& number : numbers) {
                number += weight * power;
                power *= t;
            }
            Integer numerator = 1;
            Integer denominator = 1;
            for (const IntegerFactor& factor : wide_factors) {
                numerator *= numerator_at(factor, t);
                denominator *= factor.denominator * t.denominator();
            }
            expected += weight * Rational(numerator, denominator);
        }
        different_from_zero += expected.is_zero() ? 0 : 1;
        const BlossomSums sums(RationalVector(numbers), 1);
        Rational value;
        sums.evaluate(wide_factors, 0, {&value, 1});
        CHECK(value == expected);
        if (wide) continue;
        sums.evaluate(factors, 0, {&value, 1});
        CHECK(value == expected);
    }
    CHECK(different_from_zero > 110);
}

TEST_CASE("sums by residues of factors beyond words and of negative denominators", "[blossom_sums]") {
    Random random(8);
    for (int i = 0; i < 60; ++i) {
        const std::size_t n = 16 + random.below(8);
        std::vector<Rational> numbers;
        for (std::size_t k = 0; k <= n; ++k) numbers.push_back(rational(random));
        std::vector<IntegerFactor> factors;
        std::vector<Rational> product{1};
        for (std::size_t k = 0; k < n; ++k) {
            Integer denominator = integer(random);
            if (denominator.is_zero()) denominator = -7;
            factors.push_back({integer(random), integer(random), denominator});
            const Rational constant(factors.back().constant, denominator);
            const Rational slope(factors.back().slope, denominator);
            product.emplace_back();
            for (std::size_t j = product.size() - 1; j > 0; --j)
                product[j] = constant * product[j] + slope * product[j - 1];
            product[0] *= constant;
        }
        Rational expected;
        for (std::size_t k = 0; k <= n; ++k) expected += numbers[k] * product[k];
        const BlossomSums sums(RationalVector(numbers), 1);
        CHECK(sums.kernel(factors) == SumKernel::residues);
        Rational value;
        sums.evaluate(factors, 0, {&value, 1});
        CHECK(value == expected);
    }
}

// Their magnitudes straddle those that one more group of primes is taken for, and half the product of primes.
TEST_CASE("sums by residues at the limits of a number of primes", "[blossom_sums]") {
    for (const std::size_t n : {std::size_t{16}, std::size_t{80}}) {
        for (std::size_t rest = 10; rest <= 460; rest += n == 16 ? 1 : 3) {
            for (const int sign : {-1, 1}) {
                // The bound is close for 62 bits, which are charged as such.
                const std::int64_t slope = (std::int64_t{1} << (n == 16 ? 60 : 62)) - (n == 16 ? 0 : 1);
                Case given = power_case(n, slope, ((Integer(1) << rest) - 1) * sign);
                const Rational expected = given.numbers.back() * pow(Rational(slope), n);
                for (const bool opposite : {false, true}) {
                    if (opposite) {
                        std::swap(given.numbers.front(), given.numbers.back());
                        for (WordFactor& factor : given.factors) std::swap(factor.constant, factor.slope);
                    }
                    const BlossomSums sums(RationalVector(given.numbers), 1);
                    REQUIRE(sums.kernel(given.factors) == SumKernel::residues);
                    Rational value;
                    sums.evaluate(given.factors, 0, {&value, 1});
                    CHECK(value == expected);
                }
            }
        }
    }
}

TEST_CASE("one prepared row is asked by several threads for sums of growing size", "[blossom_sums]") {
    Random random(9);
    std::vector<Case> cases;
    const Case first = random_case(random, 20, 700, 60);
    std::vector<Rational> expected;
    for (std::size_t i = 0; i < 12; ++i) {
        cases.push_back({first.numbers, random_case(random, 20, 1, 6 + 5 * i).factors});
        expected.push_back(evident_sum(first.numbers, cases.back().factors));
    }
    const BlossomSums sums(RationalVector(first.numbers), 1);
    std::vector<Rational> values(24);
    const auto work = [&](std::size_t thread) {
        for (std::size_t i = 0; i < 12; ++i)
            sums.evaluate(cases[i].factors, 0, std::span(values).subspan(12 * thread + i, 1));
    };
    std::jthread other(work, 1);
    work(0);
    other.join();
    for (std::size_t i = 0; i < 24; ++i) CHECK(values[i] == expected[i % 12]);
}
