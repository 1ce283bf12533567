// Kronecker's substitution: each polynomial is written into one integer, with every coefficient in a slot of
// the same number of words, large enough for each coefficient of the product.

#include <blossom/rational/integer_polynomials.hpp>
#include <blossom/rational/rational_vector.hpp>
#include <blossom/rational/resource_budget.hpp>

#include <algorithm>
#include <bit>

#include "limbs/limb_arithmetic.hpp"

namespace blossom {

namespace {

using WordList = std::vector<std::uint64_t>;

/// The magnitude of a polynomial's value at 2^(64 slot).
struct Packed {
    WordList words;
    bool negative;
};

Packed packed(std::span<const Integer> polynomial, std::size_t slot) {
    Packed value{WordList(polynomial.size() * slot), false};
    // A negative coefficient takes 1 from the slot above it.
    bool borrow = false;
    for (std::size_t k = 0; k < polynomial.size(); ++k) {
        const std::span place = std::span(value.words).subspan(k * slot, slot);
        IntegerAccess::to_twos_complement(polynomial[k], place);
        for (std::size_t i = 0; borrow && i < slot; ++i) borrow = place[i]-- == 0;
        borrow = static_cast<std::int64_t>(place.back()) < 0;
    }
    value.negative = borrow;
    if (value.negative) limbs::negate(value.words.data(), value.words.size());
    return value;
}

/// Reads the coefficients, each with its sign, from the slots of the value.
void unpack(Packed value, std::size_t slot, std::span<Integer> polynomial) {
    if (value.negative) limbs::negate(value.words.data(), value.words.size());
    bool carry = false;
    for (std::size_t k = 0; k < polynomial.size(); ++k) {
        const std::span place = std::span(value.words).subspan(k * slot, slot);
        const bool negative = static_cast<std::int64_t>(place.back()) < 0;
        for (std::size_t i = 0; carry && i < slot; ++i) carry = ++place[i] == 0;
        polynomial[k] = IntegerAccess::from_twos_complement(place);
        carry = negative;
    }
}

Packed multiplied(const Packed& a, const Packed& b) {
    const bool a_is_longer = a.words.size() >= b.words.size();
    const WordList& longer = a_is_longer ? a.words : b.words;
    const WordList& shorter = a_is_longer ? b.words : a.words;
    spend_work(words_of_product(longer.size(), shorter.size()));
    Packed product{WordList(longer.size() + shorter.size()), a.negative != b.negative};
    limbs::multiply(product.words.data(), longer.data(), longer.size(), shorter.data(), shorter.size());
    return product;
}

}  // namespace

IntegerPolynomial product(std::span<const Integer> a, std::span<const Integer> b) {
    constexpr std::size_t least_size = 8;
    if (a.empty() || b.empty()) return {};
    IntegerPolynomial result(a.size() + b.size() - 1);
    const std::size_t size = std::min(a.size(), b.size());
    if (limbs::multiplies_long_numbers_fast && size >= least_size) {
        const std::size_t bits = greatest_bit_length(a) + greatest_bit_length(b) +
                                 static_cast<std::size_t>(std::bit_width(size)) + 1;
        const std::size_t slot = bits / 64 + 1;
        unpack(multiplied(packed(a, slot), packed(b, slot)), slot, result);
        return result;
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) result[i + j].add_product(a[i], b[j]);
    }
    return result;
}

}  // namespace blossom
