#pragma once

#include <blossom/rational/rational.hpp>

#include "backend.hpp"
#include "uint128.hpp"

namespace blossom {

/// Access to the representation of Rational for the sources of this layer.
struct RationalAccess {
    /// Two integers, each of which is a word and an address.
    static constexpr bool is_four_words = IntegerAccess::is_word_and_address &&
                                          offsetof(Rational, numerator_) == 0 &&
                                          offsetof(Rational, denominator_) == 16 && sizeof(Rational) == 32;

    /// numerator / denominator without reduction: in lowest terms, with a positive denominator.
    static Rational from_lowest_terms(Integer numerator, Integer denominator) {
        return {std::move(numerator), std::move(denominator), Rational::Reduced{}};
    }
    /// numerator / denominator, reduced, for a denominator > 0.
    static Rational from_words(std::int64_t numerator, std::int64_t denominator) {
        const auto common = static_cast<std::int64_t>(
            gcd_of_words(magnitude(numerator), static_cast<std::uint64_t>(denominator)));
        if (common == 1) return from_lowest_terms(numerator, denominator);
        return from_lowest_terms(numerator / common, denominator / common);
    }
    /// In lowest terms from binary digits, see IntegerAccess::set_magnitude.
    static void set_lowest_terms(Rational& value, std::span<const std::uint64_t> numerator, bool negative,
                                 std::span<const std::uint64_t> denominator) {
        IntegerAccess::set_magnitude(value.numerator_, numerator, negative);
        IntegerAccess::set_magnitude(value.denominator_, denominator, false);
    }
    /// Multiplies by a factor > 0 that has no prime in common with the numerator, which is not 0.
    static void multiply_denominator(Rational& value, const Integer& factor) { value.denominator_ *= factor; }
    [[gnu::always_inline]] static void set_words(Rational& value, std::int64_t numerator,
                                                 std::int64_t denominator) {
        IntegerAccess::set_word(value.numerator_, numerator);
        IntegerAccess::set_word(value.denominator_, denominator);
    }
};

}  // namespace blossom
