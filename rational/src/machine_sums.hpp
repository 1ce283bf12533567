#pragma once

// Sums over products of linear factors in words of 64 and 128 bits. All arithmetic wraps, so that only the
// sums themselves have to fit.

#include <blossom/rational/linear_factor_sums.hpp>

#include <span>

#include "factor_blocks.hpp"
#include "quotient_reduction.hpp"
#include "wide.hpp"

namespace blossom {

/// One row of numbers words[k] / prod denominators.
struct WordRow {
    std::span<const std::int64_t> words;
    std::uint64_t greatest;  ///< magnitude
    std::span<const std::uint64_t> denominators;
};

namespace machine_sums {

/// The most factors of words that are multiplied without taking memory.
inline constexpr std::size_t most_factors = 64;

/// The denominator of the sum, if it and the bound on the numerator are below 2^63; otherwise 0.
inline std::uint64_t word_denominator(const WordRow& row, std::span<const WordFactor> factors) {
    std::uint64_t bound = row.greatest;
    std::uint64_t denominator = 1;
    bool overflow = factors.size() > most_factors;
    for (const std::uint64_t factor : row.denominators)
        overflow |= __builtin_mul_overflow(denominator, factor, &denominator);
    for (const WordFactor& factor : factors) {
        overflow |= __builtin_mul_overflow(bound, size_of(factor), &bound);
        overflow |=
            __builtin_mul_overflow(denominator, static_cast<std::uint64_t>(factor.denominator), &denominator);
    }
    return overflow || ((bound | denominator) >> 63) != 0 ? 0 : denominator;
}

/// The denominators of the row and of the factors.
inline DenominatorWords denominator_words(std::span<const std::uint64_t> denominators,
                                          std::span<const WordFactor> factors) {
    DenominatorWords words;
    for (const std::uint64_t factor : denominators) words.multiply(factor);
    for (const WordFactor& factor : factors) words.multiply(static_cast<std::uint64_t>(factor.denominator));
    return words;
}

/// Multiplies the polynomial in product[0..degree] by `block`.
template <class Word>
void multiply(Word* product, std::size_t degree, std::span<const std::int64_t> block) {
    for (std::size_t k = degree + block.size(); k-- > 0;) {
        const std::size_t first = k > degree ? k - degree : 0;
        const std::size_t last = std::min(k + 1, block.size());
        Word sum = 0;
        for (std::size_t j = first; j < last; ++j) sum += product[k - j] * static_cast<Word>(block[j]);
        product[k] = sum;
    }
}

/// The coefficients of the product of all factors.
template <class Word>
class FactorProduct {
public:
    explicit FactorProduct(std::span<const WordFactor> factors) {
        coefficients_[0] = 1;
        if constexpr (sizeof(Word) == sizeof(std::uint64_t)) {
            multiply_one_by_one(factors, coefficients_);
        } else {
            FactorBlock block;
            for (std::size_t degree = 0; degree < factors.size(); degree += block.degree()) {
                block.fill(factors.subspan(degree));
                multiply(coefficients_, degree, block.coefficients());
            }
        }
    }

    Word sum_of_products(std::span<const std::int64_t> numbers) const {
        Word sum = 0;
        for (std::size_t k = 0; k < numbers.size(); ++k)
            sum += static_cast<Word>(numbers[k]) * coefficients_[k];
        return sum;
    }

private:
    Word coefficients_[most_factors + 1];
};

/// The apex of the triangle with the weights (constant, slope) on the level of each factor.
template <class Word>
Word apex(std::span<const std::int64_t> row, std::span<const WordFactor> factors) {
    Word entries[most_factors + 1];
    for (std::size_t k = 0; k < row.size(); ++k) entries[k] = static_cast<Word>(row[k]);
    for (std::size_t level = 0; level < factors.size(); ++level) {
        const auto left = static_cast<Word>(factors[level].constant);
        const auto right = static_cast<Word>(factors[level].slope);
        for (std::size_t j = 0; j + level < factors.size(); ++j)
            entries[j] = left * entries[j] + right * entries[j + 1];
    }
    return entries[0];
}

/// A numerator of 128 bits over the denominators of the row and the factors.
Rational reduced(Wide numerator, const DenominatorWords& denominator);

}  // namespace machine_sums

}  // namespace blossom
