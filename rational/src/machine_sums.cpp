#include "machine_sums.hpp"

#include <algorithm>

#include "fixed_width_rows.hpp"

namespace blossom {

namespace machine_sums {

Rational reduced(Wide numerator, const DenominatorWords& denominator) {
    const auto value = static_cast<SignedWide>(numerator);
    const Wide size = magnitude(value);
    const std::uint64_t words[] = {static_cast<std::uint64_t>(size), static_cast<std::uint64_t>(size >> 64)};
    return reduced_quotient(std::span(words).first(words[1] == 0 ? 1 : 2), value < 0, denominator.words(), 1);
}

namespace {

WordRow row_of(std::span<const std::int64_t> words, std::span<const std::uint64_t> denominators) {
    std::uint64_t greatest = 0;
    for (const std::int64_t word : words) greatest = std::max(greatest, magnitude(word));
    return {words, greatest, denominators};
}

/// The value in the narrowest word that holds it: `numerator(Word{})` computes it.
template <class Numerator>
std::optional<Rational> value_in_words(const WordRow& row, std::span<const WordFactor> factors,
                                       const Numerator& numerator) {
    if (const std::uint64_t denominator = word_denominator(row, factors)) {
        Rational value;
        set_reduced(value, static_cast<std::int64_t>(numerator(std::uint64_t{})), denominator);
        return value;
    }
    fixed_width::BitBound bound;
    bound.multiply(row.greatest);
    for (const WordFactor& factor : factors) bound.multiply(size_of(factor));
    if (factors.size() > most_factors || bound.bits() > 127) return std::nullopt;
    return reduced(numerator(Wide{}), denominator_words(row.denominators, factors));
}

}  // namespace

}  // namespace machine_sums

std::optional<Rational> LinearFactorSums::sum_in_words(std::span<const std::int64_t> row,
                                                       std::span<const std::uint64_t> denominators,
                                                       std::span<const WordFactor> factors) {
    return machine_sums::value_in_words(
        machine_sums::row_of(row, denominators), factors, [&](auto word) -> decltype(word) {
            return machine_sums::FactorProduct<decltype(word)>(factors).sum_of_products(row);
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
