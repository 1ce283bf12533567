#include "blossom_sums_cases.hpp"
#include "rational_test.hpp"

// Every kernel compared with the evident formula on Rational, at the limits of each kernel.

TEST_CASE("sums over products of linear factors of every size", "[blossom_sums]") {
    Random random(4);
    Met met;
    for (int i = 0; i < 20'000; ++i) {
        const std::size_t n = random.below(i % 20 == 0 ? 30 : 9);
        const std::size_t bits = 1 + random.below(random.one_in(4) ? 62 : 12);
        check(random_case(random, n, random.below(random.one_in(8) ? 400 : 60), bits), met);
    }
    CHECK(met[SumKernel::word] > 1000);
    CHECK(met[SumKernel::wide] > 1000);
    CHECK(met[SumKernel::limbs] > 1000);
    CHECK(met[SumKernel::residues] > 30);
    CHECK(met[SumKernel::integers] > 30);
}

TEST_CASE("factors and denominators at the limits of a word", "[blossom_sums]") {
    Random random(5);
    Met met;
    const std::int64_t extremes[] = {greatest_word, -greatest_word, greatest_word - 1, 0, 1, -1};
    for (int i = 0; i < 5000; ++i) {
        Case given;
        const std::size_t n = random.below(7);
        for (std::size_t k = 0; k <= n; ++k)
            given.numbers.emplace_back(extremes[random.below(6)], random.one_in(3) ? greatest_word : 3);
        for (std::size_t k = 0; k < n; ++k) {
            given.factors.push_back({extremes[random.below(6)], extremes[random.below(6)],
                                     random.one_in(2) ? greatest_word : greatest_word - 4});
        }
        check(given, met);
    }
    CHECK(met[SumKernel::limbs] > 1000);
}

TEST_CASE("much cancels: numerators and denominators that share primes", "[blossom_sums]") {
    Random random(6);
    Met met;
    for (int i = 0; i < 5000; ++i) {
        Case given = random_case(random, 1 + random.below(24), 30, 1);
        for (WordFactor& factor : given.factors) {
            const auto share = static_cast<std::int64_t>(2 + random.below(30));
            factor = {share * random.between(-9, 9), share * random.between(-9, 9),
                      share * random.between(1, 30)};
        }
        check(given, met);
    }
    CHECK(met[SumKernel::word] > 100);
    CHECK(met[SumKernel::wide] > 100);
    CHECK(met[SumKernel::limbs] > 100);
}

TEST_CASE("sums without factors, and rows of zeros", "[blossom_sums]") {
    Met met;
    check({{Rational(7, 3)}, {}}, met);
    check({{Rational()}, {}}, met);
    check({{Rational(0), Rational(0)}, {{5, 7, 9}}}, met);
    check({{Rational(pow(Integer(3), 500), 2), Rational(1)}, {{greatest_word, -greatest_word, 2}}}, met);
    check({std::vector<Rational>(71, Rational(1, 2)), std::vector<WordFactor>(70, {1, 1, 2})}, met);
}

TEST_CASE("sums start at the requested row", "[blossom_sums]") {
    const std::vector<Rational> numbers{1, Rational(1, 2), 3, 4, Rational(-5, 7), pow(Rational(3), 90)};
    const BlossomSums sums(RationalVector(numbers), 3);
    CHECK(sums.rows() == 3);
    CHECK(sums.degree() == 1);
    const std::vector<WordFactor> factor{{2, 3, 5}};
    std::vector<Rational> values(2);
    sums.evaluate(factor, 1, values);
    for (std::size_t j = 0; j < 2; ++j) {
        CHECK(values[j] == evident_sum(std::span<const Rational>(numbers).subspan(2 * j + 2, 2), factor));
    }
}

TEST_CASE("every kernel has one rule, in order", "[blossom_sums]") {
    int expected = 0;
    for (const SumKernelRule& rule : sum_kernel_rules()) {
        CHECK(static_cast<int>(rule.kernel) == expected++);
        CHECK_FALSE(rule.name.empty());
        CHECK_FALSE(rule.condition.empty());
    }
}

TEST_CASE("more factors than residues take: products by halves", "[blossom_sums]") {
    Random random(20261129);
    constexpr std::size_t n = 4200;
    std::vector<WordFactor> factors;
    std::vector<IntegerFactor> large;
    for (std::size_t i = 0; i < n; ++i) {
        const std::int64_t constant = random.between(-5, 5);
        const std::int64_t slope = i % 97 == 0 ? 0 : random.between(-5, 5);
        factors.push_back({constant == 0 ? 1 : constant, slope, random.between(1, 3)});
        large.push_back({factors.back().constant, factors.back().slope, factors.back().denominator});
    }
    // The row of powers x^k makes the sum the value of the product at x.
    for (const std::int64_t x : {2, -1, 0}) {
        std::vector<Rational> row;
        Rational expected = 1;
        Rational power = 1;
        for (std::size_t k = 0; k <= n; ++k, power *= x) row.push_back(power);
        for (const WordFactor& factor : factors)
            expected *= Rational(factor.constant + x * factor.slope, factor.denominator);
        const BlossomSums sums{RationalVector(row), 1, BlossomSums::Use::once};
        Rational of_words;
        Rational of_integers;
        CHECK(sums.kernel(factors) == SumKernel::integers);
        sums.evaluate(factors, 0, {&of_words, 1});
        sums.evaluate(large, 0, {&of_integers, 1});
        CHECK((of_words == expected));
        CHECK((of_integers == expected));
    }
}
