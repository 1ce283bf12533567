#include "word_sums.hpp"

#include <algorithm>

#include "fixed_width_rows.hpp"

namespace blossom {

namespace machine_sums {

void set_reduced(Rational& value, Wide numerator, const DenominatorWords& denominator) {
    const auto signed_numerator = static_cast<SignedWide>(numerator);
    const Wide size = magnitude(signed_numerator);
    std::uint64_t words[] = {static_cast<std::uint64_t>(size), static_cast<std::uint64_t>(size >> 64)};
    blossom::set_reduced(value, words, signed_numerator < 0, denominator, {});
}

namespace {

WordRow row_of(std::span<const std::int64_t> words, std::span<const std::uint64_t> denominators) {
    std::uint64_t greatest = 0;
    for (const std::int64_t word : words) greatest = std::max(greatest, magnitude(word));
    small_primes::Set primes = 0;
    for (const std::uint64_t factor : denominators) primes |= small_primes::primes_of(factor);
    std::int64_t product = 1;
    for (const std::uint64_t factor : denominators)
        if (__builtin_mul_overflow(product, factor, &product)) product = 0;
    return {words, static_cast<std::int64_t>(greatest), denominators, product, primes};
}

/// The value in the narrowest word that holds it: `numerator(Word{})` computes it.
template <class Numerator>
std::optional<Rational> value_in_words(const WordRow& row, std::span<const WordFactor> factors,
                                       const Numerator& numerator) {
    if (const WordDenominator denominator = word_denominator(row, factors); denominator.value != 0) {
        Rational value;
        blossom::set_reduced(value, static_cast<std::int64_t>(numerator(std::uint64_t{})),
                             static_cast<std::uint64_t>(denominator.value), denominator.primes);
        return value;
    }
    fixed_width::BitBound bound;
    bound.multiply(static_cast<std::uint64_t>(row.greatest));
    for (const WordFactor& factor : factors) bound.multiply(size_of(factor));
    if (factors.size() > most_factors || bound.bits() > 127) return std::nullopt;
    Rational value;
    set_reduced(value, numerator(Wide{}), denominator_words(row.denominators, row.primes, factors));
    return value;
}

}  // namespace

}  // namespace machine_sums

std::optional<Rational> LinearFactorSums::sum_in_words(std::span<const std::int64_t> row,
                                                       std::span<const std::uint64_t> denominators,
                                                       std::span<const WordFactor> factors) {
    return machine_sums::value_in_words(
        machine_sums::row_of(row, denominators), factors, [&](auto word) -> decltype(word) {
            if constexpr (sizeof(word) == sizeof(std::uint64_t)) {
                return machine_sums::FactorProduct<>(factors).sum_of_products(row);
            } else {
                return machine_sums::WideFactorProduct(factors).sum_of_products(row);
            }
        });
}

std::optional<Rational> LinearFactorSums::apex_in_words(std::span<const std::int64_t> row,
                                                        std::span<const std::uint64_t> denominators,
                                                        std::span<const WordFactor> factors) {
    return machine_sums::value_in_words(
        machine_sums::row_of(row, denominators), factors,
        [&](auto word) -> decltype(word) { return machine_sums::apex<decltype(word)>(row, factors); });
}

}  // namespace blossom
