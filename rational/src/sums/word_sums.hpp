#pragma once

// Sums over products of linear factors in words of 64 and 128 bits. All arithmetic wraps, so that only the
// sums themselves have to fit.

#include <blossom/rational/blossom_sums.hpp>

#include <span>

#include "factor_blocks.hpp"
#include "number/uint128.hpp"
#include "quotients/word_quotients.hpp"

namespace blossom {

/// One row of numbers words[k] / prod denominators.
struct NumeratorRow {
    std::span<const std::int64_t> words;
    std::int64_t greatest;  ///< the largest magnitude
    std::span<const std::uint64_t> denominators;
    std::int64_t denominator;  ///< the product of the denominators if it is below 2^63; otherwise 0
    small_primes::Set primes;  ///< of the denominators
};

namespace word_sums {

/// The most factors in words that are multiplied without allocating memory.
inline constexpr std::size_t most_factors = 64;

/// A denominator of one word and its odd primes; no denominator is 0.
struct WordDenominator {
    std::int64_t value = 0;
    small_primes::Set primes = 0;
};

/// The denominator of the sum if it and the bound on the numerator are below 2^63; otherwise 0.
template <std::size_t Count>
[[gnu::always_inline]] inline WordDenominator word_denominator(const NumeratorRow& row,
                                                               std::span<const WordFactor, Count> factors) {
    std::int64_t bound = row.greatest;
    std::int64_t denominator = row.denominator;
    small_primes::SetOfFactors primes(row.primes);
    if (factors.size() > most_factors) return {};
    // If a norm does not fit in 63 bits, the bound is wrong; the sign of `sizes` shows this.
    std::int64_t sizes = 0;
    for (const WordFactor& factor : factors) {
        const auto size = static_cast<std::int64_t>(l1_norm(factor));
        sizes |= size;
        if (__builtin_mul_overflow(bound, size, &bound) ||
            __builtin_mul_overflow(denominator, factor.denominator, &denominator))
            return {};
        primes.add(static_cast<std::uint64_t>(factor.denominator));
    }
    if (sizes < 0) return {};
    return {denominator, primes.set()};
}

/// The denominators of the row and of the factors.
inline DenominatorWords denominator_words(std::span<const std::uint64_t> denominators,
                                          small_primes::Set primes, std::span<const WordFactor> factors) {
    DenominatorWords words;
    for (const std::uint64_t factor : denominators) words.multiply(factor, primes);
    for (const WordFactor& factor : factors) {
        const auto bottom = static_cast<std::uint64_t>(factor.denominator);
        words.multiply(bottom, small_primes::primes_of(bottom));
    }
    return words;
}

/// The product of all factors in words of 64 bits.
template <std::size_t Count = std::dynamic_extent>
class FactorProduct {
public:
    // The unused part of the array is left uninitialized: clearing it would cost more than the work.
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
    [[gnu::always_inline]] explicit FactorProduct(std::span<const WordFactor, Count> factors) {
        coefficients_[0] = 1;
        multiply_one_by_one(factors, coefficients_);
    }

    std::uint64_t sum_of_products(std::span<const std::int64_t> numbers) const {
        std::uint64_t sum = 0;
        for (std::size_t k = 0; k <= Count; ++k)
            sum += static_cast<std::uint64_t>(numbers[k]) * coefficients_[k];
        return sum;
    }

private:
    std::uint64_t coefficients_[Count + 1];
};

/// The product as two halves a and b that are not multiplied with each other: sum_i a_i sum_j b_j c_(i+j).
template <>
class FactorProduct<std::dynamic_extent> {
public:
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
    explicit FactorProduct(std::span<const WordFactor> factors)
        : first_degree_((factors.size() + 1) / 2), second_degree_(factors.size() / 2) {
        multiply_out(factors.first(first_degree_), first_);
        multiply_out(factors.last(second_degree_), second_);
    }

    std::uint64_t sum_of_products(std::span<const std::int64_t> numbers) const {
        return with_small_constant(second_degree_, [&](auto degree) {
            const std::size_t terms = (degree == std::dynamic_extent ? second_degree_ : degree) + 1;
            std::uint64_t sum = 0;
            for (std::size_t i = 0; i <= first_degree_; ++i) {
                std::uint64_t inner = 0;
                for (std::size_t j = 0; j < terms; ++j)
                    inner += static_cast<std::uint64_t>(numbers[i + j]) * second_[j];
                sum += inner * first_[i];
            }
            return sum;
        });
    }

private:
    static void multiply_out(std::span<const WordFactor> factors, std::uint64_t* coefficients) {
        coefficients[0] = 1;
        with_small_constant(factors.size(), [&](auto count) {
            multiply_one_by_one(std::span<const WordFactor, count>(factors.data(), factors.size()),
                                coefficients);
        });
    }

    std::size_t first_degree_;
    std::size_t second_degree_;
    std::uint64_t first_[most_factors / 2 + 1];
    std::uint64_t second_[most_factors / 2 + 1];
};

/// The product of all factors in blocks, for sums in words of 128 bits.
/// The unused part of the array is left uninitialized, because clearing it would take longer than the
/// computation.
/// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
class WideFactorProduct {
public:
    /// Requires that the magnitudes of all coefficients of the product sum to less than 2^127.
    explicit WideFactorProduct(std::span<const WordFactor> factors) {
        while (!factors.empty()) {
            // Factors that do not fit in one block are split into two halves.
            blocks_[size_].fill(factors, size_ == 0 ? (factors.size() + 1) / 2 : factors.size());
            factors = factors.subspan(blocks_[size_++].degree());
        }
    }

    /// sum_k numbers[k] e_k: each block B replaces the numbers c by sum_j B_j c_(i+j), which are fewer by its
    /// degree.
    UInt128 sum_of_products(std::span<const std::int64_t> numbers) const {
        if (size_ == 0) return static_cast<UInt128>(Int128{numbers[0]});
        UInt128 sums[most_factors + 1];
        std::size_t count = numbers.size() - blocks_[0].degree();
        fold(blocks_[0], numbers.data(), count, sums);
        for (std::size_t i = 1; i < size_; ++i) {
            count -= blocks_[i].degree();
            fold(blocks_[i], sums, count, sums);
        }
        return sums[0];
    }

private:
    template <class Number>
    static void fold(const FactorBlock& block, const Number* numbers, std::size_t count, UInt128* sums) {
        with_small_constant(block.degree(), [&](auto degree) {
            const std::span<const std::int64_t> weights = block.coefficients();
            const std::size_t terms = degree == std::dynamic_extent ? weights.size() : degree + 1;
            for (std::size_t i = 0; i < count; ++i) {
                UInt128 sum = 0;
                for (std::size_t j = 0; j < terms; ++j)
                    sum += static_cast<UInt128>(static_cast<Int128>(numbers[i + j]) * weights[j]);
                sums[i] = sum;
            }
        });
    }

    /// The magnitudes of two adjacent blocks sum to at least 2^63.
    static constexpr std::size_t most_blocks = 5;

    std::size_t size_ = 0;
    FactorBlock blocks_[most_blocks];
};

/// The apex of the triangle with the weights (constant, slope) of factor i on level i.
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

/// Sets `value` to a numerator of 128 bits over the denominators of the row and the factors.
void assign_quotient(Rational& value, UInt128 numerator, const DenominatorWords& denominator);

}  // namespace word_sums

}  // namespace blossom
