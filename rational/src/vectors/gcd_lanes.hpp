#pragma once

// Greatest common divisors in vector lanes. Only what the sources compiled for single instruction sets may
// include: nothing inline from elsewhere, which the linker could take for all.

#include <cstddef>
#include <cstdint>

namespace blossom::gcd_lanes {

/// The number of pairs of words at a time.
inline constexpr std::size_t word_pairs = 16;

/// The number of longer factors at a time, their digits, and the bits of a digit.
inline constexpr std::size_t factor_count = 8;
inline constexpr std::size_t most_digits = 7;
inline constexpr std::size_t digit_bits = 52;

/// Odd factors by their digits, least significant first.
struct alignas(64) Factors {
    std::uint64_t digits[most_digits][factor_count];
    std::uint64_t negative_inverses[factor_count];  ///< -1/factor modulo 2^52
};

struct Operations {
    /// odd[i] = gcd(odd[i], other[i]) for odd numbers and others, which are used up.
    void (*words)(std::uint64_t* odd, std::uint64_t* other);
    /// Each factor becomes its gcd with the number, which is given by `count` digits.
    void (*longer)(const std::uint64_t* number, std::size_t count, Factors& factors);
};

extern const Operations avx512_operations;

}  // namespace blossom::gcd_lanes
