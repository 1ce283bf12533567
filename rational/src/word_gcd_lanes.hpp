#pragma once

// Greatest common divisors of words in vector lanes. Only what the sources compiled for single instruction
// sets may include.

#include <cstddef>
#include <cstdint>

namespace blossom::word_gcd_lanes {

/// The number of pairs at a time.
inline constexpr std::size_t pairs_at_once = 16;

/// odd[i] = gcd(odd[i], other[i]) for 16 odd numbers and 16 others, which are used up.
using Gcds = void (*)(std::uint64_t* odd, std::uint64_t* other);

#if defined(BLOSSOM_AVX512_GCDS)
void avx512_gcds(std::uint64_t* odd, std::uint64_t* other);
#endif

}  // namespace blossom::word_gcd_lanes
