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

    /// Multiplies by a factor > 0. Adjacent words are multiplied together while the product is a word.
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

/// The known factors of the denominator. With `search`, small primes are split off those that are longer than
/// a word.
DenominatorParts split_denominator(const RationalVector& numbers, bool search);

struct BlossomSums::PreparedRows {
    PreparedRows(RationalVector numbers, std::size_t rows, Use use);

    std::span<const Integer> integers_of(std::size_t row) const {
        return std::span(numbers.numerators()).subspan(row * size, size);
    }
    /// Row `row`; only if all numerators are words.
    NumeratorRow words_of(std::size_t row) const {
        return {std::span(words).subspan(row * size, size), greatest, denominator.words, word_denominator,
                primes};
    }
    /// Whether the words of the denominator are few enough for fixed-size storage.
    bool has_few_words() const { return denominator.words.size() <= most_denominators; }
    /// The two's complement of a row, `width` words per number.
    const std::uint64_t* limbs_of(std::size_t row) const { return limbs.data() + row * size * width; }

    static constexpr std::size_t most_denominators = 32;

    RationalVector numbers;
    Use use;
    std::size_t rows;
    std::size_t size;                  ///< the length of a row, n + 1
    std::size_t bits;                  ///< of the largest magnitude
    std::vector<std::int64_t> words;   ///< empty unless all numerators are words
    std::int64_t greatest = 0;         ///< the largest magnitude among `words`
    std::size_t width;                 ///< the words per number in `limbs`
    std::vector<std::uint64_t> limbs;  ///< empty if the numbers are too wide
    SumDigits digits;
    DenominatorParts denominator;
    std::int64_t word_denominator =
        1;  ///< the product of the denominator's words if it is below 2^63; otherwise 0
    small_primes::Set primes = 0;  ///< the odd primes of these words
    ResidueCache residues;
};

}  // namespace blossom
