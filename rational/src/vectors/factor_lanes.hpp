#pragma once

// Linear factors in vector lanes; only for sources compiled for AVX-512.

// NOLINTBEGIN(portability-simd-intrinsics): without these instructions, one product is computed after the
// other
#include <immintrin.h>

#include <cstddef>
#include <cstdint>

namespace blossom::factor_lanes {

namespace {

/// (constant + slope X) / denominator in each lane.
struct Factor {
    __m512i constant;
    __m512i slope;
    __m512i denominator;
};

/// |constant| + |slope|
inline __m512i l1_norm(const Factor& factor) {
    return _mm512_add_epi64(_mm512_abs_epi64(factor.constant), _mm512_abs_epi64(factor.slope));
}

/// A mask of all bits of the first lanes.
template <std::size_t Lanes = 8>
std::uint64_t united(__m512i words) {
    if constexpr (Lanes > 4) words = _mm512_or_si512(words, _mm512_shuffle_i64x2(words, words, 0x4e));
    if constexpr (Lanes > 2) words = _mm512_or_si512(words, _mm512_shuffle_i64x2(words, words, 0xb1));
    words = _mm512_or_si512(words, _mm512_unpackhi_epi64(words, words));
    return static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm512_extracti32x4_epi32(words, 0)));
}

}  // namespace

}  // namespace blossom::factor_lanes

// NOLINTEND(portability-simd-intrinsics)
