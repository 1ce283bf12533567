#pragma once

// Greatest common divisors in vector lanes. This header contains only what the sources compiled for one
// instruction set may include: no inline functions, which the linker could choose for the whole program.

#include <cstddef>
#include <cstdint>

namespace blossom::gcd_lanes {

/// The number of pairs of words per call.
inline constexpr std::size_t word_pairs = 16;

/// The number of longer factors per call, their most digits, and the bits of a digit.
inline constexpr std::size_t factor_count = 8;
inline constexpr std::size_t most_digits = 7;
inline constexpr std::size_t digit_bits = 52;

/// Odd factors in digits, least significant first.
struct alignas(64) Factors {
    std::uint64_t digits[most_digits][factor_count];
    std::uint64_t negative_inverses[factor_count];  ///< -1/factor modulo 2^52
};

struct Operations {
    /// odd[i] = gcd(odd[i], other[i]) for odd numbers and arbitrary others, which are destroyed.
    void (*words)(std::uint64_t* odd, std::uint64_t* other);
    /// Replaces each factor by its gcd with the number, which has `count` digits.
    void (*longer)(const std::uint64_t* number, std::size_t count, Factors& factors);
};

extern const Operations avx512_operations;

}  // namespace blossom::gcd_lanes
