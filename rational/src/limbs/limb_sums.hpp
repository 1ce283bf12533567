#pragma once

// Sums of products of integers of a fixed number of words.

#include <cstddef>
#include <cstdint>
#include <span>

namespace blossom {

/// The widest sums with code for a fixed width, in words, sign included.
inline constexpr std::size_t most_sum_limbs = 8;

/// Integers in two's complement of `width` words each, at a distance of `stride` words.
struct LimbView {
    const std::uint64_t* words;
    std::size_t width;
    std::size_t stride;
};

/// sum_k a_k b_k for k < count in two's complement, modulo 2^(64 sum.size()), with sum.size() <=
/// most_sum_limbs.
void limb_dot(LimbView a, LimbView b, std::size_t count, std::span<std::uint64_t> sum);

}  // namespace blossom
