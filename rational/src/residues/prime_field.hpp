#pragma once

// Arithmetic modulo one prime below 2^63, one number at a time.

#include <blossom/rational/integer.hpp>

#include <utility>

#include "modular_words.hpp"

namespace blossom {

/// The field of the residues below the prime.
class PrimeField {
public:
    explicit PrimeField(std::uint64_t prime) : prime_(prime) {}

    std::uint64_t prime() const { return prime_; }

    std::uint64_t of(const Integer& value) const {
        const std::int64_t rest = *(value % Integer(prime_)).to_int64();
        return static_cast<std::uint64_t>(rest < 0 ? rest + static_cast<std::int64_t>(prime_) : rest);
    }
    std::uint64_t sum(std::uint64_t a, std::uint64_t b) const {
        const std::uint64_t sum = a + b;
        return sum >= prime_ ? sum - prime_ : sum;
    }
    std::uint64_t product(std::uint64_t a, std::uint64_t b) const { return modular::product(a, b, prime_); }
    std::uint64_t power(std::uint64_t base, std::uint64_t exponent) const {
        return modular::power(base, exponent, prime_);
    }
    /// 1/a for a > 0, by Euclid's algorithm.
    std::uint64_t inverse(std::uint64_t a) const {
        auto before = static_cast<std::int64_t>(prime_);
        auto now = static_cast<std::int64_t>(a);
        std::int64_t cofactor_before = 0;
        std::int64_t cofactor = 1;
        while (now != 0) {
            const std::int64_t quotient = before / now;
            before = std::exchange(now, before - quotient * now);
            cofactor_before = std::exchange(cofactor, cofactor_before - quotient * cofactor);
        }
        return static_cast<std::uint64_t>(
            cofactor_before < 0 ? cofactor_before + static_cast<std::int64_t>(prime_) : cofactor_before);
    }

private:
    std::uint64_t prime_;
};

}  // namespace blossom
