#pragma once

// Which of the small primes divide a number, all of them at a time. Only what the sources compiled for single
// instruction sets may include: nothing inline from elsewhere, which the linker could take for all.

#include <cstddef>
#include <cstdint>

namespace blossom::prime_lanes {

inline constexpr std::size_t lanes = 8;
inline constexpr std::size_t primes_a_lane = 4;
inline constexpr std::size_t digit_bits = 52;

/// Odd primes, of which lane i has those with the numbers i, i + lanes, ... Inverses are modulo 2^52.
struct alignas(64) Table {
    /// Of the primes of each lane together, below 2^52.
    std::uint64_t products[lanes];
    std::uint64_t inverses_of_products[lanes];
    /// x * inverse modulo 2^52 is x / p if that is at most `most`, and otherwise p does not divide x < 2^52.
    std::uint64_t inverses[primes_a_lane][lanes];
    std::uint64_t most[primes_a_lane][lanes];
};

/// The primes that divide the number in `words`, least significant first: bit k stands for prime k.
using Divisors = std::uint32_t (*)(const Table& table, const std::uint64_t* words, std::size_t size);

std::uint32_t avx512_divisors(const Table& table, const std::uint64_t* words, std::size_t size);

}  // namespace blossom::prime_lanes
