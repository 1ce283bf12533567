#pragma once

// Factors and rows for BlossomSums, and the evident formula on Rational, one operation after the other.

#include <blossom/rational/blossom_sums.hpp>

#include <map>
#include <vector>

#include "support/number_generators.hpp"
#include "support/number_printing.hpp"

namespace blossom::testing {

inline constexpr std::int64_t greatest_word = INT64_MAX;

/// sum_k c_k e_k from the definition: multiplies one factor after the other, in lowest terms throughout.
template <class R>
Rational evident_sum(std::span<const Rational> numbers, const std::vector<LinearFactor<R>>& factors) {
    std::vector<Rational> product{1};
    for (const LinearFactor<R>& factor : factors) {
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

/// The sum prepared for many uses and for one.
template <class R>
void check_quotient(const std::vector<Rational>& numbers, const std::vector<LinearFactor<R>>& factors) {
    const Rational expected = evident_sum<R>(numbers, factors);
    for (const auto use : {BlossomSums::Use::many, BlossomSums::Use::once}) {
        Rational value;
        BlossomSums(RationalVector(numbers), 1, use).evaluate(factors, 0, {&value, 1});
        CHECK(value == expected);
    }
}

inline std::int64_t word_of_bits(Random& random, std::size_t bits) {
    if (bits == 0 || random.one_in(12)) return 0;
    if (random.one_in(8)) return (std::int64_t{1} << bits) - 1;
    if (random.one_in(8)) return 1 - (std::int64_t{1} << bits);
    return random.between(1 - (std::int64_t{1} << bits), (std::int64_t{1} << bits) - 1);
}

inline std::int64_t denominator_of_bits(Random& random, std::size_t bits) {
    return random.between(1, (std::int64_t{1} << bits) - 1);
}

struct Case {
    std::vector<Rational> numbers;
    std::vector<WordFactor> factors;
};

/// A number of `bits` bits over a denominator of at most `denominator_bits`.
inline Rational number_of_bits(Random& random, std::size_t bits, std::size_t denominator_bits) {
    return {integer_of_bits(random, bits), denominator_of_bits(random, denominator_bits)};
}

inline Case random_case(Random& random, std::size_t n, std::size_t number_bits, std::size_t factor_bits) {
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

inline std::vector<IntegerFactor> beyond_words(std::span<const WordFactor> factors) {
    std::vector<IntegerFactor> result;
    for (const auto& [constant, slope, denominator] : factors)
        result.push_back({constant, slope, denominator});
    return result;
}

/// The triangle of a row, weighted by a factor per level.
inline Rational evident_apex(std::vector<Integer> row, Integer denominator,
                             std::span<const WordFactor> factors) {
    for (const WordFactor& factor : factors) {
        for (std::size_t j = 0; j + 1 < row.size(); ++j)
            row[j] = row[j] * factor.constant + row[j + 1] * factor.slope;
        row.pop_back();
        denominator *= factor.denominator;
    }
    return {row[0], denominator};
}

/// Checks the sums of one row that need no preparation, if its numbers are words.
inline void check_unprepared(std::span<const Integer> numerators, const Integer& denominator,
                             std::span<const WordFactor> factors, const Rational& expected) {
    std::vector<std::int64_t> row;
    for (const Integer& numerator : numerators) {
        const auto word = numerator.to_int64();
        if (!word || *word == INT64_MIN) return;
        row.push_back(*word);
    }
    const auto word = denominator.to_int64();
    if (!word) return;
    const std::uint64_t denominators[] = {static_cast<std::uint64_t>(*word), 1};
    if (const auto sum = BlossomSums::sum_in_words(row, denominators, factors)) CHECK(*sum == expected);
    if (const auto apex = BlossomSums::apex_in_words(row, denominators, factors))
        CHECK(*apex == evident_apex({numerators.begin(), numerators.end()}, denominator, factors));
}

/// The kernels that the cases of a test used.
using Met = std::map<SumKernel, std::size_t>;

inline void check(const Case& given, Met& met) {
    const RationalVector numbers(given.numbers);
    const BlossomSums sums(numbers, 1);
    Rational value;
    sums.evaluate(given.factors, 0, {&value, 1});
    const Rational expected = evident_sum(given.numbers, given.factors);
    CHECK(value == expected);
    sums.evaluate(beyond_words(given.factors), 0, {&value, 1});
    CHECK(value == expected);
    ++met[sums.kernel(given.factors)];
    BlossomSums(numbers, 1, BlossomSums::Use::once).evaluate(given.factors, 0, {&value, 1});
    CHECK(value == expected);
    check_unprepared(numbers.numerators(), numbers.denominator(), given.factors, expected);
}

}  // namespace blossom::testing
