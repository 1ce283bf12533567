#pragma once

// The rows of BlossomSums in the forms that the kernels read.

#include <blossom/rational/blossom_sums.hpp>

#include <vector>

#include "digit_sums.hpp"
#include "residue_sums.hpp"
#include "word_sums.hpp"

namespace blossom {

/// Positive numbers whose product is a denominator.
struct DenominatorParts {
    std::vector<std::uint64_t> words;
    std::vector<Integer> longer;

    /// By a factor > 0. Neighbouring words are multiplied as long as they stay one word.
    void multiply(const Integer& factor) {
        if (!factor.is_word()) {
            longer.push_back(factor);
        } else if (!factor.is_one()) {
            const auto word = static_cast<std::uint64_t>(factor.word());
            std::uint64_t product = 0;
            if (!words.empty() && !__builtin_mul_overflow(words.back(), word, &product)) {
                words.back() = product;
            } else {
                words.push_back(word);
            }
        }
    }
};

/// From the factors that are known. `search` splits small primes off those that are longer than a word.
DenominatorParts split_denominator(const RationalVector& numbers, bool search);

struct BlossomSums::PreparedRows {
    PreparedRows(RationalVector numbers, std::size_t rows, Use use);

    std::span<const Integer> integers_of(std::size_t row) const {
        return std::span(numbers.numerators()).subspan(row * size, size);
    }
    /// Only if there are words.
    NumeratorRow words_of(std::size_t row) const {
        return {std::span(words).subspan(row * size, size), greatest, denominator.words, word_denominator,
                primes};
    }
    /// Whether the words of the denominator are few enough to be held in place.
    bool has_few_words() const { return denominator.words.size() <= most_denominators; }
    /// `width` words of two's complement a number.
    const std::uint64_t* limbs_of(std::size_t row) const { return limbs.data() + row * size * width; }

    static constexpr std::size_t most_denominators = 32;

    RationalVector numbers;
    Use use;
    std::size_t rows;
    std::size_t size;                  ///< the length of a row, n + 1
    std::size_t bits;                  ///< of the greatest magnitude
    std::vector<std::int64_t> words;   ///< empty unless all numerators are words
    std::int64_t greatest = 0;         ///< the greatest magnitude among `words`
    std::size_t width;                 ///< of one number in `limbs`
    std::vector<std::uint64_t> limbs;  ///< empty when the numbers are too wide
    SumDigits digits;
    DenominatorParts denominator;
    std::int64_t word_denominator = 1;  ///< the product of its words, if it is below 2^63; otherwise 0
    small_primes::Set primes = 0;       ///< of its words
    ResidueCache residues;
};

}  // namespace blossom
