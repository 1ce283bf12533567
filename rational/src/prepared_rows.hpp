#pragma once

// The rows of LinearFactorSums in the forms that the kernels read.

#include <blossom/rational/linear_factor_sums.hpp>

#include <vector>

#include "digit_sums.hpp"
#include "machine_sums.hpp"
#include "residue_sums.hpp"

namespace blossom {

struct LinearFactorSums::Prepared {
    Prepared(RationalVector numbers, std::size_t rows, Use use);

    std::span<const Integer> integers_of(std::size_t row) const {
        return std::span(numbers.numerators()).subspan(row * size, size);
    }
    /// Only if there are words.
    WordRow words_of(std::size_t row) const {
        return {std::span(words).subspan(row * size, size), greatest, denominators, word_denominator, primes};
    }
    /// `width` words of two's complement a number.
    const std::uint64_t* limbs_of(std::size_t row) const { return limbs.data() + row * size * width; }

    RationalVector numbers;
    Use use;
    std::size_t rows;
    std::size_t size;                  ///< the length of a row, n + 1
    std::size_t bits;                  ///< of the greatest magnitude
    std::vector<std::int64_t> words;   ///< empty unless all numerators are words
    std::int64_t greatest = 0;         ///< the greatest magnitude among `words`
    std::size_t width;                 ///< of one number in `limbs`
    std::vector<std::uint64_t> limbs;  ///< empty when the numbers are too wide
    DigitRows digits;
    std::vector<std::uint64_t> denominators;  ///< factors of the common denominator
    std::int64_t word_denominator = 1;        ///< their product, if it is below 2^63; otherwise 0
    small_primes::Set primes = 0;             ///< of `denominators`
    Integer further_denominator;              ///< the common denominator divided by them
    ResidueCache residues;
};

/// Splits off the small prime factors of `value` > 0, gathered in words; what is left stays in `value`, or
/// becomes one more word.
std::vector<std::uint64_t> split_into_words(Integer& value);

}  // namespace blossom
