#pragma once

// Quotients of a few words in lowest terms. Denominators are given as words whose prime factors are mostly
// small: one multiplication tests each prime, and no greatest common divisor is taken.

#include <blossom/rational/rational.hpp>

#include <span>

#include "number/rational_access.hpp"
#include "small_primes.hpp"

namespace blossom {

/// Words whose product is a denominator, as few as greedy packing gives.
/// The unused part of the array is left uninitialized, because clearing it would take longer than the
/// computation.
/// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
class DenominatorWords {
public:
    /// Multiplies by a factor with these odd primes.
    void multiply(std::uint64_t factor, small_primes::Set primes) {
        primes_ |= primes;
        std::uint64_t product = 0;
        if (size_ > 0 && !__builtin_mul_overflow(words_[size_ - 1], factor, &product)) {
            words_[size_ - 1] = product;
        } else {
            words_[size_++] = factor;
        }
    }
    std::span<const std::uint64_t> words() const { return {words_, size_}; }
    small_primes::Set primes() const { return primes_; }

    static constexpr std::size_t most_words = 96;

private:
    std::size_t size_ = 0;
    small_primes::Set primes_ = 0;
    std::uint64_t words_[most_words];
};

/// Sets `value` to numerator / denominator in lowest terms, for a positive denominator below 2^63.
void assign_quotient_by_gcd(Rational& value, std::int64_t numerator, std::uint64_t denominator);

/// The same for a denominator with these odd primes.
[[gnu::always_inline]] inline void assign_quotient(Rational& value, std::int64_t numerator,
                                                   std::uint64_t denominator, small_primes::Set primes) {
    if (numerator == 0 || primes == small_primes::any_primes)
        return assign_quotient_by_gcd(value, numerator, denominator);
    std::uint64_t size = magnitude(numerator);
    const int twos = std::countr_zero(size | denominator);
    size >>= twos;
    denominator >>= twos;
    small_primes::for_each(primes, [&](const small_primes::Prime& prime) {
        for (;;) {
            const std::uint64_t top = size * prime.inverse;
            if (top > prime.most) return;
            const std::uint64_t bottom = denominator * prime.inverse;
            if (bottom > prime.most) return;
            size = top;
            denominator = bottom;
        }
    });
    const auto top = static_cast<std::int64_t>(size);
    RationalAccess::set_words(value, numerator < 0 ? -top : top, static_cast<std::int64_t>(denominator));
}

/// Sets `value` to sign * numerator / (denominator * prod further) for a numerator in words, least
/// significant first, which are overwritten.
void assign_quotient(Rational& value, std::span<std::uint64_t> numerator, bool negative,
                     const DenominatorWords& denominator, std::span<const Integer> further);

}  // namespace blossom
