#pragma once

// Sums over products of linear factors whose numerators are near the limit of a kernel, and their values by
// the evident formula.

#include <algorithm>
#include <map>
#include <vector>

#include "each_case.hpp"
#include "rational/blossom_sums_cases.hpp"

namespace blossom::testing {

/// Rows of numerators over one denominator, one after the other, and factors.
struct SumCase {
    std::vector<Integer> numerators;
    Integer denominator = 1;
    std::vector<WordFactor> factors;

    std::size_t rows() const { return numerators.size() / (factors.size() + 1); }
    BlossomSums sums(BlossomSums::Use use = BlossomSums::Use::many) const {
        return {RationalVector(numerators, denominator), rows(), use};
    }
};

/// The sums with the factors multiplied in integers, one after the other; zero coefficients at both ends are
/// skipped.
inline std::vector<Rational> evident_values(std::span<const Integer> numerators, const Integer& denominator,
                                            std::span<const IntegerFactor> factors) {
    std::vector<Integer> product{1};
    std::size_t shift = 0;  // the power of X in front of `product`
    Integer bottom = denominator;
    for (const IntegerFactor& factor : factors) {
        bottom *= factor.denominator;
        if (factor.constant.is_zero()) {
            for (Integer& coefficient : product) coefficient *= factor.slope;
            ++shift;
            continue;
        }
        if (!factor.slope.is_zero()) product.emplace_back();
        for (std::size_t k = product.size() - 1; k > 0; --k)
            product[k] = factor.constant * product[k] + factor.slope * product[k - 1];
        product[0] *= factor.constant;
    }
    std::vector<Rational> values;
    for (std::size_t row = 0; row < numerators.size(); row += factors.size() + 1) {
        Integer sum;
        for (std::size_t k = 0; k < product.size(); ++k) sum += numerators[row + shift + k] * product[k];
        values.emplace_back(sum, bottom);
    }
    return values;
}
inline std::vector<Rational> evident_values(const SumCase& given) {
    return evident_values(given.numerators, given.denominator, beyond_words(given.factors));
}

/// The signs of the numbers of a case.
enum class Signs {
    alike,      ///< the bound on the sum is attained
    alternate,  ///< the same for factors whose coefficients have different signs
    any,
};

inline Signs any_signs(Random& random) {
    return random.one_in(3) ? Signs::alike : random.one_in(2) ? Signs::alternate : Signs::any;
}

/// A word of at most `bits` bits, usually exactly this many.
inline std::int64_t word_near(Random& random, std::size_t bits) {
    return *abs(number_near(random, bits)).to_int64();
}

/// A factor whose coefficients have about `bits` bits.
inline WordFactor factor_near(Random& random, std::size_t bits, std::size_t denominator_bits, Signs signs) {
    std::int64_t constant = word_near(random, bits);
    std::int64_t slope = word_near(random, bits);
    if (constant == 0 && slope == 0 && !random.one_in(20)) constant = 1;
    if (signs == Signs::alternate || (signs == Signs::any && random.one_in(2))) slope = -slope;
    if (signs == Signs::any && random.one_in(2)) constant = -constant;
    return {constant, slope,
            std::max<std::int64_t>(1, word_near(random, random.below(denominator_bits + 1)))};
}

inline std::vector<WordFactor> factors_near(Random& random, std::size_t n, std::size_t bits,
                                            std::size_t denominator_bits, Signs signs) {
    std::vector<WordFactor> factors;
    while (factors.size() < n) factors.push_back(factor_near(random, bits, denominator_bits, signs));
    return factors;
}

/// prod (|constant| + |slope|)
inline Integer size_of_product(std::span<const WordFactor> factors) {
    Integer size = 1;
    for (const WordFactor& factor : factors)
        size *= abs(Integer(factor.constant)) + abs(Integer(factor.slope));
    return size;
}

/// Factors with as many bits each as bring this product near 2^bits.
inline std::vector<WordFactor> factors_filling(Random& random, std::size_t n, std::size_t bits,
                                               std::size_t denominator_bits, Signs signs) {
    std::vector<WordFactor> factors;
    while (factors.size() < n) {
        const std::size_t filled = size_of_product(factors).bit_length();
        const std::size_t share = (bits - std::min(bits, filled)) / (n - factors.size());
        factors.push_back(
            factor_near(random, std::clamp<std::size_t>(share, 1, 62), denominator_bits, signs));
    }
    return factors;
}

/// Rows of numbers whose largest is the largest for which the bound on the sums is below 2^bits; sometimes
/// one more.
inline SumCase case_at_limit(Random& random, std::vector<WordFactor> factors, std::size_t bits, Signs signs) {
    SumCase result;
    result.factors = std::move(factors);
    const Integer size = size_of_product(result.factors);
    Integer most = size.is_zero() ? Integer(5) : ((Integer(1) << bits) - 1) / size;
    if (random.one_in(3)) most += 1;
    const std::size_t rows = random.one_in(4) ? 2 : 1;
    const int sign = random.one_in(2) ? 1 : -1;
    for (std::size_t k = 0; k < rows * (result.factors.size() + 1); ++k) {
        Integer number = most;
        if (signs == Signs::any && k != 0 && !random.one_in(4))
            number = number_near(random, most.bit_length() - (most.is_zero() ? 0 : 1));
        const bool negative = signs == Signs::alternate && k % (result.factors.size() + 1) % 2 == 1;
        result.numerators.push_back(number * (negative ? -sign : sign));
    }
    if (random.one_in(2)) result.denominator = 1 + random.below(1000);
    if (random.one_in(8)) result.denominator *= pow(Integer(1031), 1 + random.below(8));
    return result;
}

/// Compares the results of all functions for the same sums.
inline void check_sums(const SumCase& given, const std::vector<Rational>& expected, Met& met) {
    const BlossomSums prepared = given.sums();
    const BlossomSums once = given.sums(BlossomSums::Use::once);
    const std::vector<IntegerFactor> integers = beyond_words(given.factors);
    std::vector<Rational> values(given.rows());
    prepared.evaluate(given.factors, 0, values);
    check_same(values, expected);
    prepared.evaluate(integers, 0, values);
    check_same(values, expected);
    once.evaluate(given.factors, 0, values);
    check_same(values, expected);
    ++met[prepared.kernel(given.factors)];
}
inline void check_sums(const SumCase& given, Met& met) { check_sums(given, evident_values(given), met); }

/// Requires that enough cases used a kernel.
inline void require_met(Met& met, SumKernel kernel) { CHECK(4 * met[kernel] + 10 > differential_cases()); }

}  // namespace blossom::testing
