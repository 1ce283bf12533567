#pragma once

// Greatest common divisors in vector lanes. Only what the sources compiled for single instruction sets may
// include: nothing inline from elsewhere, which the linker could take for all.

#include <cstddef>
#include <cstdint>

namespace blossom::gcd_lanes {

/// The number of pairs of words at a time.
inline constexpr std::size_t word_pairs = 16;

/// odd[i] = gcd(odd[i], other[i]) for so many odd numbers and others, which are used up.
using Gcds = void (*)(std::uint64_t* odd, std::uint64_t* other);

void avx512_gcds(std::uint64_t* odd, std::uint64_t* other);

}  // namespace blossom::gcd_lanes
