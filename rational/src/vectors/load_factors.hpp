#pragma once

// Linear factors in vector lanes, read from pairs of numbers; only for sources compiled for AVX-512.

// NOLINTBEGIN(portability-simd-intrinsics): what has no lanes computes one product after the other
#include <immintrin.h>

#include <cstddef>
#include <cstdint>

namespace blossom::load_factors {

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

/// A pair of numbers u, m for the factor m + u X is so many words: of u and of m a numerator and a
/// denominator, each a word and an address that is not 0 where there is no word.
inline constexpr std::size_t pair_words = 8;

/// Of all pairs united, the bits that are 0 if every u is a quotient of words and every m is 0 or 1: all but
/// those of the words of u and the lowest ones of the words of m, of which the denominator then is 1.
inline __m512i surplus(__m512i all_pairs) {
    return _mm512_and_si512(all_pairs, _mm512_set_epi64(-1, ~1LL, -1, ~1LL, -1, 0, -1, 0));
}

/// The factors of so many pairs, two, four or eight, in lanes 0, 1, ...; the lanes beyond hold anything.
template <std::size_t Count>
[[gnu::always_inline]] inline Factor factor_of(const __m512i* pairs) {
    const auto from = [](__m512i slopes, __m512i denominators, __m512i masses) {
        const __m512i all_or_nothing = _mm512_sub_epi64(_mm512_setzero_si512(), masses);
        return Factor{_mm512_and_si512(denominators, all_or_nothing), slopes, denominators};
    };
    // The even words of two pairs: numerators and denominators of u, then of m, each 128 bits.
    __m512i twos[Count / 2];
#pragma GCC unroll 4
    for (std::size_t i = 0; i < Count / 2; ++i)
        twos[i] = _mm512_unpacklo_epi64(pairs[2 * i], pairs[2 * i + 1]);
    if constexpr (Count == 2) {
        return from(twos[0], _mm512_shuffle_i64x2(twos[0], twos[0], 1),
                    _mm512_shuffle_i64x2(twos[0], twos[0], 2));
    } else {
        constexpr std::size_t last = Count / 2 - 2;
        constexpr int lower = 0x44;        // the first and second 128 bits of both operands
        constexpr int third = 0xaa;        // the third ones
        constexpr int odd_places = 0x88;   // the first and third ones
        constexpr int even_places = 0xdd;  // the second and fourth ones
        const __m512i front = _mm512_shuffle_i64x2(twos[0], twos[1], lower);
        const __m512i back = _mm512_shuffle_i64x2(twos[last], twos[last + 1], lower);
        const __m512i masses =
            _mm512_shuffle_i64x2(_mm512_shuffle_i64x2(twos[0], twos[1], third),
                                 _mm512_shuffle_i64x2(twos[last], twos[last + 1], third), odd_places);
        return from(_mm512_shuffle_i64x2(front, back, odd_places),
                    _mm512_shuffle_i64x2(front, back, even_places), masses);
    }
}

/// All bits of the first lanes.
template <std::size_t Lanes = 8>
std::uint64_t united(__m512i words) {
    if constexpr (Lanes > 4) words = _mm512_or_si512(words, _mm512_shuffle_i64x2(words, words, 0x4e));
    if constexpr (Lanes > 2) words = _mm512_or_si512(words, _mm512_shuffle_i64x2(words, words, 0xb1));
    words = _mm512_or_si512(words, _mm512_unpackhi_epi64(words, words));
    return static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm512_extracti32x4_epi32(words, 0)));
}

}  // namespace

}  // namespace blossom::load_factors

// NOLINTEND(portability-simd-intrinsics)
