#pragma once

// Quotients in lowest terms, by way of factors of the denominator: with G = prod gcd(N, f_i) over any
// factors f_i of D, gcd(N, D) = gcd(N, G), and G is small when little cancels.

#include <blossom/rational/rational.hpp>

#include <span>
#include <vector>

#include "rational_access.hpp"

namespace blossom {

/// Words whose product is a denominator, as few as greedy packing gives.
// What is not used yet of the array stays as it is: clearing it would cost more than the work.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
class DenominatorWords {
public:
    void multiply(std::uint64_t factor) {
        std::uint64_t product = 0;
        if (size_ > 0 && !__builtin_mul_overflow(words_[size_ - 1], factor, &product)) {
            words_[size_ - 1] = product;
        } else {
            words_[size_++] = factor;
        }
    }
    std::span<const std::uint64_t> words() const { return {words_, size_}; }

    static constexpr std::size_t most_words = 96;

private:
    std::size_t size_ = 0;
    std::uint64_t words_[most_words];
};

/// numerator / denominator, both below 2^63 in magnitude, the denominator positive.
inline void set_reduced(Rational& value, std::int64_t numerator, std::uint64_t denominator) {
    const std::uint64_t size = magnitude(numerator);
    const std::uint64_t common = gcd_of_words(size % denominator, denominator);
    if (common == 1) {
        RationalAccess::set_words(value, numerator, static_cast<std::int64_t>(denominator));
        return;
    }
    const auto quotient = static_cast<std::int64_t>(size / common);
    RationalAccess::set_words(value, numerator < 0 ? -quotient : quotient,
                              static_cast<std::int64_t>(denominator / common));
}

/// sign * numerator / (prod denominator * further), where `numerator` is in words, least significant first.
Rational reduced_quotient(std::span<const std::uint64_t> numerator, bool negative,
                          std::span<const std::uint64_t> denominator, const Integer& further);

/// numerator / prod factors, all factors positive. Cost: the remainders of the numerator by a tree of the
/// factors, and one gcd a factor.
Rational reduced_quotient(const Integer& numerator, std::span<const Integer> factors);

}  // namespace blossom
