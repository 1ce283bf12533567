#include "prepared_rows.hpp"

#include <limits>

#include "backend.hpp"
#include "limb_sums.hpp"
#include "wide.hpp"

namespace blossom {

namespace {

/// Denominators of up to ten bits, and the binomials of any likely degree, have no larger prime factors.
constexpr std::int64_t greatest_trial = 1023;

constexpr std::size_t most_denominators = 16;

}  // namespace

std::vector<std::uint64_t> split_into_words(Integer& value) {
    std::vector<std::uint64_t> words;
    std::uint64_t gathered = 1;
    const auto gather = [&](std::uint64_t factor) {
        std::uint64_t product = 0;
        if (__builtin_mul_overflow(gathered, factor, &product)) {
            words.push_back(gathered);
            product = factor;
        }
        gathered = product;
    };
    for (std::int64_t trial = 2; trial <= greatest_trial && !value.to_int64(); trial += trial == 2 ? 1 : 2) {
        while (!value.to_int64() && (value % trial).is_zero()) {
            value = divide_exactly(value, trial);
            gather(static_cast<std::uint64_t>(trial));
        }
    }
    if (const auto word = value.to_int64()) {
        gather(static_cast<std::uint64_t>(*word));
        value = 1;
    }
    if (gathered != 1) words.push_back(gathered);
    return words;
}

LinearFactorSums::Prepared::Prepared(RationalVector given, std::size_t row_count, Use use_of_rows)
    : numbers(std::move(given)),
      use(use_of_rows),
      rows(row_count),
      size(numbers.size() / row_count),
      bits(greatest_bit_length(numbers.numerators())),
      width(bits / 64 + 1),
      further_denominator(numbers.denominator()) {
    if (use == Use::many || further_denominator.to_int64())
        denominators = split_into_words(further_denominator);
    if (denominators.size() > most_denominators) {
        denominators.clear();
        further_denominator = numbers.denominator();
    }
    for (const std::uint64_t factor : denominators) {
        primes |= small_primes::table.factored(factor);
        if (__builtin_mul_overflow(word_denominator, factor, &word_denominator)) word_denominator = 0;
    }
    if (bits < 64 && further_denominator.is_one()) {
        words.reserve(numbers.size());
        for (const Integer& numerator : numbers.numerators()) {
            words.push_back(*numerator.to_int64());
            greatest = std::max(greatest, std::abs(words.back()));
        }
    }
    if (width <= most_sum_limbs) {
        limbs.resize(numbers.size() * width);
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            IntegerAccess::to_twos_complement(numbers.numerators()[k],
                                              std::span(limbs).subspan(k * width, width));
        }
        digits = DigitRows({limbs.data(), width, width}, numbers.size(), size, bits);
    }
}

}  // namespace blossom
