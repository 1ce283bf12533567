#include "quotient_reduction.hpp"

#include <algorithm>

namespace blossom {

namespace {

constexpr std::size_t most_words = DenominatorWords::most_words + 1;

std::uint64_t remainder(std::span<const std::uint64_t> words, std::uint64_t divisor) {
    std::uint64_t rest = 0;
    for (std::size_t i = words.size(); i-- > 0;) {
        rest = static_cast<std::uint64_t>((Wide{rest} << 64 | words[i]) % divisor);
    }
    return rest;
}

/// A number >= 0 in words on the stack.
struct Words {
    std::uint64_t words[most_words];
    std::size_t size = 1;

    std::span<const std::uint64_t> span() const { return {words, size}; }

    void multiply(std::uint64_t factor) {
        Wide carry = 0;
        for (std::size_t i = 0; i < size; ++i) {
            carry += Wide{words[i]} * factor;
            words[i] = static_cast<std::uint64_t>(carry);
            carry >>= 64;
        }
        if (carry != 0) words[size++] = static_cast<std::uint64_t>(carry);
    }
    void divide(std::uint64_t divisor) {
        Wide rest = 0;
        for (std::size_t i = size; i-- > 0;) {
            rest = rest << 64 | words[i];
            words[i] = static_cast<std::uint64_t>(rest / divisor);
            rest %= divisor;
        }
    }
};

}  // namespace

Rational reduced_quotient(std::span<const std::uint64_t> numerator, bool negative,
                          std::span<const std::uint64_t> denominator, const Integer& further) {
    std::uint64_t shared = 1;
    bool shared_fits = further.is_one() && numerator.size() <= most_words;
    for (const std::uint64_t factor : denominator) {
        if (!shared_fits) break;
        const std::uint64_t common = gcd_of_words(remainder(numerator, factor), factor);
        shared_fits = !__builtin_mul_overflow(shared, common, &shared);
    }
    Words bottom;
    bottom.words[0] = 1;
    for (const std::uint64_t factor : denominator) bottom.multiply(factor);
    if (!shared_fits) {
        return {IntegerAccess::from_magnitude(numerator, negative),
                IntegerAccess::from_magnitude(bottom.span(), false) * further};
    }
    if (shared != 1 && denominator.size() > 1) {
        shared = gcd_of_words(remainder(numerator, shared), shared);
    }
    if (shared == 1) {
        return RationalAccess::from_lowest_terms(IntegerAccess::from_magnitude(numerator, negative),
                                                 IntegerAccess::from_magnitude(bottom.span(), false));
    }
    Words top;
    top.size = numerator.size();
    std::ranges::copy(numerator, top.words);
    top.divide(shared);
    bottom.divide(shared);
    return RationalAccess::from_lowest_terms(IntegerAccess::from_magnitude(top.span(), negative),
                                             IntegerAccess::from_magnitude(bottom.span(), false));
}

}  // namespace blossom
