#include "prepared_rows.hpp"

#include <algorithm>
#include <cstdlib>

#include "limbs/limb_sums.hpp"
#include "number/backend.hpp"
#include "number/uint128.hpp"

namespace blossom {

namespace {

/// Denominators of up to ten bits and the binomials of typical degrees have no larger prime factors.
constexpr std::int64_t greatest_trial = 1023;

}  // namespace

DenominatorParts split_denominator(const RationalVector& numbers, bool search) {
    DenominatorParts parts;
    for (Integer factor : numbers.denominator_factors()) {
        const std::int64_t last = search ? greatest_trial : 0;
        for (std::int64_t trial = 2; trial <= last && !factor.is_word(); trial += trial == 2 ? 1 : 2) {
            while (!factor.is_word() && (factor % trial).is_zero()) {
                factor = divide_exactly(factor, trial);
                parts.multiply(trial);
            }
        }
        parts.multiply(factor);
    }
    return parts;
}

BlossomSums::PreparedRows::PreparedRows(RationalVector given, std::size_t row_count, Use use_of_rows)
    : numbers(std::move(given)),
      use(use_of_rows),
      rows(row_count),
      size(numbers.size() / row_count),
      bits(greatest_bit_length(numbers.numerators())),
      width(bits / 64 + 1),
      denominator(split_denominator(numbers, use_of_rows == Use::many)) {
    for (const std::uint64_t factor : denominator.words) {
        if (primes != small_primes::any_primes) primes |= small_primes::table.factored(factor);
        if (__builtin_mul_overflow(word_denominator, factor, &word_denominator)) word_denominator = 0;
    }
    if (bits < 64 && denominator.longer.empty() && has_few_words()) {
        words.reserve(numbers.size());
        for (const Integer& numerator : numbers.numerators()) {
            words.push_back(*numerator.to_int64());
            greatest = std::max(greatest, std::abs(words.back()));
        }
    }
    if (width <= most_sum_limbs && has_few_words()) {
        limbs.resize(numbers.size() * width);
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            IntegerAccess::to_twos_complement(numbers.numerators()[k],
                                              std::span(limbs).subspan(k * width, width));
        }
        digits = SumDigits({limbs.data(), width, width}, numbers.size(), size, bits);
    }
}

}  // namespace blossom
