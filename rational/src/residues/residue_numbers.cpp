#include "residue_numbers.hpp"

#include <algorithm>

#include "prime_field.hpp"
#include "residue_products.hpp"

namespace blossom::residues {

namespace {

Digits digits_of(std::span<const Integer> numbers) {
    Digits digits;
    digits.reserve(numbers.size(), 1);
    for (const Integer& number : numbers) digits.push_back(number);
    return digits;
}

/// Fractions are considered if the digits of a number times the groups are at least this many (by
/// measurement).
constexpr std::size_t least_saving = 2000;
/// The additional cost of a group with fractions, in digits.
constexpr std::size_t digits_of_fraction = 40;

/// Replaces values, stored times the radix, by their inverses in the same form; returns false if one is 0.
/// Three products per value: each pair is inverted by its product. `scratch` has 3 count + 64 elements.
bool invert_each(const Moduli& moduli, ResidueVector* values, std::size_t count, ResidueVector* scratch) {
    const Operations& run = operations();
    if (count == 1) {
        run.reduce(moduli, values, 1);
        for (std::size_t i = 0; i < lanes; ++i) {
            if (values->lane[i] == 0) return false;
            values->lane[i] = PrimeField(moduli.prime.lane[i]).inverse(values->lane[i]);
        }
        // 1/(value radix), times radix^2
        run.scale(moduli, values, moduli.square, 1, values);
        run.scale(moduli, values, moduli.square, 1, values);
        return true;
    }
    const std::size_t half = count / 2;
    const std::size_t products = count - half;
    ResidueVector* const rest = scratch + products;
    run.multiply_each(moduli, values, values + half, half, scratch);
    if (products > half) scratch[half] = values[count - 1];
    if (!invert_each(moduli, scratch, products, rest)) return false;
    run.multiply_each(moduli, scratch, values + half, half, rest);
    run.multiply_each(moduli, scratch, values, half, values + half);
    std::copy_n(rest, half, values);
    if (products > half) values[count - 1] = scratch[half];
    return true;
}

}  // namespace

Numbers::Numbers(std::span<const Integer> numerators, const Integer& denominator, std::size_t groups)
    : numerators_(numerators) {
    std::size_t greatest = 0;
    for (const Integer& numerator : numerators) greatest = std::max(greatest, numerator.bit_length());
    const std::size_t digits = greatest / operations().prime_bits;
    if (digits > digits_of_fraction && (digits - digits_of_fraction) * groups > least_saving) {
        if (const auto fractions = small_fractions(numerators, denominator)) {
            digits_ = digits_of(fractions->tops);
            bottoms_ = digits_of(fractions->bottoms);
            denominator_ = digits_of({&denominator, 1});
            return;
        }
    }
    digits_ = digits_of(numerators);
}

void Numbers::residues(const Moduli& moduli, ResidueVector* residues) const {
    if (bottoms_.size() == 0)
        return digits_.residues(moduli, plain_powers(moduli, digits_.most_digits()).data(), residues);
    if (residues_of_fractions(moduli, residues)) return;
    const Digits digits = digits_of(numerators_);
    digits.residues(moduli, plain_powers(moduli, digits.most_digits()).data(), residues);
}

bool Numbers::residues_of_fractions(const Moduli& moduli, ResidueVector* residues) const {
    const std::size_t count = size();
    const Operations& run = operations();
    const std::size_t most_digits =
        std::max({digits_.most_digits(), bottoms_.most_digits(), denominator_.most_digits()});
    const std::vector<ResidueVector> powers = montgomery_powers(moduli, most_digits);
    const Buffer inverses(count);
    const Buffer scratch(3 * count + 64);
    bottoms_.residues(moduli, powers.data(), inverses.data());
    if (!invert_each(moduli, inverses.data(), count, scratch.data())) return false;
    ResidueVector denominator{};
    denominator_.residues(moduli, powers.data(), &denominator);
    // Without the factor radix, which the powers of the numerators contribute.
    const ResidueVector one = [] {
        ResidueVector result{};
        std::ranges::fill(result.lane, 1);
        return result;
    }();
    run.scale(moduli, &denominator, one, 1, &denominator);
    digits_.residues(moduli, powers.data(), residues);
    run.scale(moduli, residues, denominator, count, residues);
    run.multiply_each(moduli, residues, inverses.data(), count, residues);
    return true;
}

}  // namespace blossom::residues
