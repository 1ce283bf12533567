// Every kernel against the evident formula on Rational, operation by operation, at the limits of each kernel.

#include <blossom/rational/linear_factor_sums.hpp>

#include <algorithm>
#include <map>
#include <thread>
#include <vector>

#include "support/number_generators.hpp"
#include "support/number_printing.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

constexpr std::int64_t greatest_word = INT64_MAX;

/// sum_k c_k e_k from the definition: multiply out, one factor after the other, in lowest terms throughout.
Rational evident_sum(std::span<const Rational> numbers, std::span<const WordFactor> factors) {
    std::vector<Rational> product{1};
    for (const WordFactor& factor : factors) {
        const Rational constant(factor.constant, factor.denominator);
        const Rational slope(factor.slope, factor.denominator);
        product.emplace_back();
        for (std::size_t k = product.size() - 1; k > 0; --k)
            product[k] = constant * product[k] + slope * product[k - 1];
        product[0] *= constant;
    }
    Rational sum;
    for (std::size_t k = 0; k < product.size(); ++k) sum += numbers[k] * product[k];
    return sum;
}

std::int64_t word_of_bits(Random& random, std::size_t bits) {
    if (bits == 0 || random.one_in(12)) return 0;
    if (random.one_in(8)) return (std::int64_t{1} << bits) - 1;
    if (random.one_in(8)) return 1 - (std::int64_t{1} << bits);
    return random.between(1 - (std::int64_t{1} << bits), (std::int64_t{1} << bits) - 1);
}

std::int64_t denominator_of_bits(Random& random, std::size_t bits) {
    return random.between(1, (std::int64_t{1} << bits) - 1);
}

struct Case {
    std::vector<Rational> numbers;
    std::vector<WordFactor> factors;
};

/// A number of `bits` bits over a denominator of at most `denominator_bits`.
Rational number_of_bits(Random& random, std::size_t bits, std::size_t denominator_bits) {
    return {integer_of_bits(random, bits), denominator_of_bits(random, denominator_bits)};
}

Case random_case(Random& random, std::size_t n, std::size_t number_bits, std::size_t factor_bits) {
    Case result;
    for (std::size_t k = 0; k <= n; ++k) {
        const std::size_t bits = random.below(number_bits + 1);
        result.numbers.push_back(random.one_in(8) ? Rational() : number_of_bits(random, bits, 1 + bits % 10));
        if (random.one_in(64)) result.numbers.back() /= pow(Integer(1031), random.below(16));
    }
    for (std::size_t i = 0; i < n; ++i) {
        result.factors.push_back({word_of_bits(random, factor_bits), word_of_bits(random, factor_bits),
                                  denominator_of_bits(random, factor_bits)});
    }
    return result;
}

std::vector<IntegerFactor> integer_factors(std::span<const WordFactor> factors) {
    std::vector<IntegerFactor> result;
    for (const auto& [constant, slope, denominator] : factors)
        result.push_back({constant, slope, denominator});
    return result;
}

/// The apex of the triangle, in lowest terms throughout.
Rational evident_apex(std::vector<Rational> row, std::span<const WordFactor> factors) {
    for (const WordFactor& factor : factors) {
        for (std::size_t j = 0; j + 1 < row.size(); ++j)
            row[j] = (row[j] * factor.constant + row[j + 1] * factor.slope) / Rational(factor.denominator);
        row.pop_back();
    }
    return row[0];
}

/// The sums that need no preparation, where the numerators are words.
void check_unprepared(const Case& given, const Rational& expected) {
    const RationalVector numbers(given.numbers);
    std::vector<std::int64_t> row;
    for (const Integer& numerator : numbers.numerators()) {
        const auto word = numerator.to_int64();
        if (!word || *word == INT64_MIN) return;
        row.push_back(*word);
    }
    const auto denominator = numbers.denominator().to_int64();
    if (!denominator) return;
    const std::uint64_t denominators[] = {static_cast<std::uint64_t>(*denominator), 1};
    if (const auto sum = LinearFactorSums::sum_in_words(row, denominators, given.factors))
        CHECK(*sum == expected);
    if (const auto apex = LinearFactorSums::apex_in_words(row, denominators, given.factors))
        CHECK(*apex == evident_apex(given.numbers, given.factors));
}

/// Which kernels the cases of a test have met.
using Met = std::map<SumKernel, int>;

void check(const Case& given, Met& met) {
    const LinearFactorSums sums(RationalVector(given.numbers), 1);
    Rational value;
    sums.evaluate(given.factors, 0, {&value, 1});
    const Rational expected = evident_sum(given.numbers, given.factors);
    CHECK(value == expected);
    sums.evaluate(integer_factors(given.factors), 0, {&value, 1});
    CHECK(value == expected);
    ++met[sums.kernel(given.factors)];
    LinearFactorSums(RationalVector(given.numbers), 1, LinearFactorSums::Use::once)
        .evaluate(given.factors, 0, {&value, 1});
    CHECK(value == expected);
    check_unprepared(given, expected);
}

/// (c + s X) / 1 times itself, whose sum with numbers 0, ..., 0, c is c s^n.
Case power_case(std::size_t n, std::int64_t slope, const Integer& last) {
    Case result{std::vector<Rational>(n + 1), std::vector<WordFactor>(n, WordFactor{0, slope, 1})};
    result.numbers.back() = last;
    return result;
}

}  // namespace

TEST_CASE("sums over products of linear factors of every size", "[linear_factor_sums]") {
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

TEST_CASE("sums that overflow a kernel by one bit", "[linear_factor_sums]") {
    for (const std::size_t limit : {std::size_t{63}, std::size_t{127}, std::size_t{511}}) {
        const SumKernel last = limit == 63    ? SumKernel::word
                               : limit == 127 ? SumKernel::wide
                                              : SumKernel::limbs;
        for (std::size_t bits = limit - 2; bits <= limit + 2; ++bits) {
            // 2^bits - 1 in magnitude is the bound itself.
            for (const int sign : {-1, 1}) {
                Met met;
                const std::size_t n = (bits - 1) / 60;
                const Integer last_number = (Integer(1) << (bits - 60 * n)) - 1;
                check(power_case(n, std::int64_t{1} << 60, last_number * sign), met);
                check(power_case(1, 1, ((Integer(1) << bits) - 1) * sign), met);
            }
        }
        Met below;
        Met above;
        const std::size_t n = (limit - 1) / 60;
        const Integer power = Integer(1) << (limit - 60 * n);
        check(power_case(n, (std::int64_t{1} << 60) - 1, power - 1), below);
        check(power_case(n, (std::int64_t{1} << 60) - 1, power + 1), above);
        CHECK(below[last] == 1);
        CHECK(above[last] == 0);
    }
}

TEST_CASE("factors and denominators at the limits of a word", "[linear_factor_sums]") {
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

TEST_CASE("much cancels: numerators and denominators that share primes", "[linear_factor_sums]") {
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

TEST_CASE("sums without factors, and rows of zeros", "[linear_factor_sums]") {
    Met met;
    check({{Rational(7, 3)}, {}}, met);
    check({{Rational()}, {}}, met);
    check({{Rational(0), Rational(0)}, {{5, 7, 9}}}, met);
    check({{Rational(pow(Integer(3), 500), 2), Rational(1)}, {{greatest_word, -greatest_word, 2}}}, met);
    check({std::vector<Rational>(71, Rational(1, 2)), std::vector<WordFactor>(70, {1, 1, 2})}, met);
}

namespace {

/// Eight tuples of n factors with numbers of `bits` bits, and rows of `row_bits` bits; some denominators have
/// primes beyond all tables.
void check_eight(Random& random, std::size_t n, std::size_t bits, std::size_t row_bits, int& computed) {
    const std::size_t rows = 1 + random.below(3);
    std::vector<Rational> numbers;
    for (std::size_t k = 0; k < rows * (n + 1); ++k)
        numbers.push_back(Rational(word_of_bits(random, row_bits)) / Rational(1 + random.below(3)));
    const LinearFactorSums sums(RationalVector(numbers), rows);
    std::vector<WordFactorOctet> octets(n);
    std::vector<std::vector<WordFactor>> tuples(8);
    const bool smooth = !random.one_in(8);
    for (std::size_t l = 0; l < 8; ++l) {
        for (std::size_t i = 0; i < n; ++i) {
            const std::int64_t denominator = smooth
                                                 ? denominator_of_bits(random, std::min<std::size_t>(bits, 7))
                                                 : denominator_of_bits(random, bits);
            tuples[l].push_back({word_of_bits(random, bits), word_of_bits(random, bits),
                                 denominator << (smooth && random.one_in(4) ? bits / 8 : 0)});
            octets[i].constants[l] = tuples[l][i].constant;
            octets[i].slopes[l] = tuples[l][i].slope;
            octets[i].denominators[l] = tuples[l][i].denominator;
        }
    }
    std::vector<Rational> values(8 * rows, Rational(7, 9));
    if (!sums.evaluate_eight(octets, values)) {
        CHECK(values == std::vector<Rational>(8 * rows, Rational(7, 9)));
        return;
    }
    ++computed;
    for (std::size_t l = 0; l < 8; ++l) {
        for (std::size_t j = 0; j < rows; ++j) {
            const std::span<const Rational> row = std::span(numbers).subspan(j * (n + 1), n + 1);
            CHECK(values[l * rows + j] == evident_sum(row, tuples[l]));
        }
    }
}

}  // namespace

TEST_CASE("eight tuples at a time", "[linear_factor_sums]") {
    Random random(18);
    int computed = 0;
    for (int i = 0; i < 2'000; ++i) {
        const std::size_t n = random.below(10);
        // About as many bits as fit in 51 and in 63, and more.
        const std::size_t bits = 1 + random.below(n == 0 ? 60 : std::clamp<std::size_t>(66 / n, 2, 62));
        check_eight(random, n, bits, 1 + random.below(20), computed);
    }
    for (std::size_t bits = 40; bits <= 62; ++bits)
        for (int i = 0; i < 40; ++i) check_eight(random, 1, bits - 2, 1 + random.below(4), computed);
    // Where the processor has no lanes nothing is computed, and everywhere else most.
    CHECK((computed == 0 || computed > 800));
}

TEST_CASE("rows are taken from the one asked for", "[linear_factor_sums]") {
    const std::vector<Rational> numbers{1, Rational(1, 2), 3, 4, Rational(-5, 7), pow(Rational(3), 90)};
    const LinearFactorSums sums(RationalVector(numbers), 3);
    CHECK(sums.rows() == 3);
    CHECK(sums.degree() == 1);
    const WordFactor factor{2, 3, 5};
    std::vector<Rational> values(2);
    sums.evaluate({&factor, 1}, 1, values);
    for (std::size_t j = 0; j < 2; ++j) {
        CHECK(values[j] ==
              evident_sum(std::span<const Rational>(numbers).subspan(2 * j + 2, 2), {&factor, 1}));
    }
}

TEST_CASE("sums by residues", "[linear_factor_sums]") {
    Random random(7);
    Met met;
    for (int i = 0; i < 120; ++i) {
        const std::size_t n = 16 + random.below(i % 10 == 0 ? 80 : 20);
        check(random_case(random, n, 60 + random.below(900), 40 + random.below(22)), met);
    }
    CHECK(met[SumKernel::residues] > 80);
}

// With numbers w t^k the sum is w times the product of the factors at t.
TEST_CASE("sums by residues of high degree", "[linear_factor_sums]") {
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
        const LinearFactorSums sums(RationalVector(numbers), 1);
        Rational value;
        sums.evaluate(wide_factors, 0, {&value, 1});
        CHECK(value == expected);
        if (wide) continue;
        sums.evaluate(factors, 0, {&value, 1});
        CHECK(value == expected);
    }
    CHECK(different_from_zero > 110);
}

TEST_CASE("sums by residues of factors beyond words and of negative denominators", "[linear_factor_sums]") {
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
        const LinearFactorSums sums(RationalVector(numbers), 1);
        CHECK(sums.kernel(factors) == SumKernel::residues);
        Rational value;
        sums.evaluate(factors, 0, {&value, 1});
        CHECK(value == expected);
    }
}

// Their magnitudes straddle those that one more group of primes is taken for, and half the product of primes.
TEST_CASE("sums by residues at the limits of a number of primes", "[linear_factor_sums]") {
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
                    const LinearFactorSums sums(RationalVector(given.numbers), 1);
                    REQUIRE(sums.kernel(given.factors) == SumKernel::residues);
                    Rational value;
                    sums.evaluate(given.factors, 0, {&value, 1});
                    CHECK(value == expected);
                }
            }
        }
    }
}

TEST_CASE("one prepared row is asked by several threads for sums of growing size", "[linear_factor_sums]") {
    Random random(9);
    std::vector<Case> cases;
    const Case first = random_case(random, 20, 700, 60);
    std::vector<Rational> expected;
    for (std::size_t i = 0; i < 12; ++i) {
        cases.push_back({first.numbers, random_case(random, 20, 1, 6 + 5 * i).factors});
        expected.push_back(evident_sum(first.numbers, cases.back().factors));
    }
    const LinearFactorSums sums(RationalVector(first.numbers), 1);
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

TEST_CASE("every kernel has one rule, in order", "[linear_factor_sums]") {
    int expected = 0;
    for (const SumKernelRule& rule : sum_kernel_rules()) {
        CHECK(static_cast<int>(rule.kernel) == expected++);
        CHECK_FALSE(rule.name.empty());
        CHECK_FALSE(rule.condition.empty());
    }
}
