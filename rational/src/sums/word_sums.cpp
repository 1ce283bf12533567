#include "word_sums.hpp"

#include <algorithm>

#include "fixed_width_rows.hpp"

namespace blossom {

namespace word_sums {

void assign_quotient(Rational& value, UInt128 numerator, const DenominatorWords& denominator) {
    const auto signed_numerator = static_cast<Int128>(numerator);
    const UInt128 size = magnitude(signed_numerator);
    std::uint64_t words[] = {static_cast<std::uint64_t>(size), static_cast<std::uint64_t>(size >> 64)};
    blossom::assign_quotient(value, words, signed_numerator < 0, denominator, {});
}

namespace {

NumeratorRow row_of(std::span<const std::int64_t> words, std::span<const std::uint64_t> denominators) {
    std::uint64_t greatest = 0;
    for (const std::int64_t word : words) greatest = std::max(greatest, magnitude(word));
    small_primes::Set primes = 0;
    for (const std::uint64_t factor : denominators) primes |= small_primes::primes_of(factor);
    std::int64_t product = 1;
    for (const std::uint64_t factor : denominators)
        if (__builtin_mul_overflow(product, factor, &product)) product = 0;
    return {words, static_cast<std::int64_t>(greatest), denominators, product, primes};
}

/// The value of `numerator(Word{})`, computed in the narrowest word that holds it.
template <class Numerator>
std::optional<Rational> value_in_words(const NumeratorRow& row, std::span<const WordFactor> factors,
                                       const Numerator& numerator) {
    if (const WordDenominator denominator = word_denominator(row, factors); denominator.value != 0) {
        Rational value;
        blossom::assign_quotient(value, static_cast<std::int64_t>(numerator(std::uint64_t{})),
                                 static_cast<std::uint64_t>(denominator.value), denominator.primes);
        return value;
    }
    fixed_width::BitBound bound;
    bound.multiply(static_cast<std::uint64_t>(row.greatest));
    for (const WordFactor& factor : factors) bound.multiply(l1_norm(factor));
    if (factors.size() > most_factors || bound.bits() > 127) return std::nullopt;
    Rational value;
    assign_quotient(value, numerator(UInt128{}), denominator_words(row.denominators, row.primes, factors));
    return value;
}

}  // namespace

}  // namespace word_sums

std::optional<Rational> BlossomSums::sum_in_words(std::span<const std::int64_t> row,
                                                  std::span<const std::uint64_t> denominators,
                                                  std::span<const WordFactor> factors) {
    return word_sums::value_in_words(
        word_sums::row_of(row, denominators), factors, [&](auto word) -> decltype(word) {
            if constexpr (sizeof(word) == sizeof(std::uint64_t)) {
                return word_sums::FactorProduct<>(factors).sum_of_products(row);
            } else {
                return word_sums::WideFactorProduct(factors).sum_of_products(row);
            }
        });
}

std::optional<Rational> BlossomSums::apex_in_words(std::span<const std::int64_t> row,
                                                   std::span<const std::uint64_t> denominators,
                                                   std::span<const WordFactor> factors) {
    return word_sums::value_in_words(
        word_sums::row_of(row, denominators), factors,
        [&](auto word) -> decltype(word) { return word_sums::apex<decltype(word)>(row, factors); });
}

}  // namespace blossom
