#pragma once

// Divisibility by the odd primes up to 137, usually the only ones in denominators of a few digits.

#include <bit>
#include <cstddef>
#include <cstdint>

#include "number/uint128.hpp"

namespace blossom::small_primes {

/// Bit i stands for prime i. All bits together stand for numbers that may have any prime factors.
using Set = std::uint32_t;
inline constexpr Set any_primes = ~Set{0};

inline constexpr std::size_t count = 32;
inline constexpr std::uint64_t greatest_known = 4095;

/// x * inverse modulo 2^64 is x / p if it is at most `most`; otherwise p does not divide x.
struct Prime {
    std::uint64_t prime = 0;
    std::uint64_t inverse = 0;
    std::uint64_t most = 0;

    bool divides(std::uint64_t x) const { return x * inverse <= most; }
};

struct Table {
    Prime primes[count] = {};
    Set of[greatest_known + 1] = {};  ///< the odd primes of i > 0

    constexpr Table() {
        std::size_t found = 0;
        for (std::uint64_t candidate = 3; found < count; candidate += 2) {
            bool is_prime = true;
            for (std::size_t i = 0; i < found; ++i) is_prime = is_prime && candidate % primes[i].prime != 0;
            if (is_prime)
                primes[found++] = {candidate, inverse_of_odd(candidate), ~std::uint64_t{0} / candidate};
        }
        for (std::uint64_t i = 1; i <= greatest_known; ++i) of[i] = i % 2 == 0 ? of[i / 2] : factored(i);
    }

    /// The odd primes of a number > 0.
    constexpr Set factored(std::uint64_t number) const {
        Set set = 0;
        std::uint64_t odd = number >> std::countr_zero(number);
        for (std::size_t i = 0; i < count; ++i) {
            while (odd % primes[i].prime == 0) {
                odd /= primes[i].prime;
                set |= Set{1} << i;
            }
        }
        return odd == 1 ? set : any_primes;
    }
};
inline constexpr Table table;

/// The odd primes of a factor > 0 of a denominator, by the table.
inline Set primes_of(std::uint64_t factor) {
    return factor <= greatest_known ? table.of[factor] : any_primes;
}

/// The odd primes of a product of factors.
class SetOfFactors {
public:
    explicit SetOfFactors(Set set) : set_(set) {}

    /// Adds a factor > 0. Whether all factors are in the table is checked only at the end.
    void add(std::uint64_t factor) {
        set_ |= table.of[factor & greatest_known];
        all_ |= factor;
    }
    Set set() const { return all_ <= greatest_known ? set_ : any_primes; }

private:
    static_assert((greatest_known & (greatest_known + 1)) == 0);

    Set set_;
    std::uint64_t all_ = 0;
};

/// Calls visit(prime) for the primes in `set`.
template <class Visit>
[[gnu::always_inline]] inline void for_each(Set set, const Visit& visit) {
    for (; set != 0; set &= set - 1) visit(table.primes[std::countr_zero(set)]);
}

}  // namespace blossom::small_primes
