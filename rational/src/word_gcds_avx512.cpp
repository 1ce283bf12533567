#include <immintrin.h>

#include "word_gcd_lanes.hpp"

namespace blossom::word_gcd_lanes {

namespace {

constexpr std::size_t vectors = 2;
constexpr std::size_t vector_lanes = pairs_at_once / vectors;

}  // namespace

// The binary algorithm: while the other number is not 0, its twos are shifted out, and the two are replaced
// by the lesser one and the difference. Two vectors in turns, because each step waits for the one before.
void avx512_gcds(std::uint64_t* odd, std::uint64_t* other) {
    const __m512i zero = _mm512_setzero_si512();
    const __m512i top = _mm512_set1_epi64(63);
    __m512i u[vectors];
    __m512i v[vectors];
    for (std::size_t i = 0; i < vectors; ++i) {
        u[i] = _mm512_loadu_si512(odd + vector_lanes * i);
        v[i] = _mm512_loadu_si512(other + vector_lanes * i);
    }
    for (bool busy = true; busy;) {
        __mmask8 left = 0;
        for (std::size_t i = 0; i < vectors; ++i) {
            const __m512i lowest_bit = _mm512_and_si512(v[i], _mm512_sub_epi64(zero, v[i]));
            // For 0 the count is out of range, and the shift gives 0.
            const __m512i shifted =
                _mm512_srlv_epi64(v[i], _mm512_sub_epi64(top, _mm512_lzcnt_epi64(lowest_bit)));
            const __mmask8 positive = _mm512_test_epi64_mask(shifted, shifted);
            const __m512i lesser = _mm512_min_epu64(u[i], shifted);
            v[i] = _mm512_maskz_sub_epi64(positive, _mm512_max_epu64(u[i], shifted), lesser);
            u[i] = _mm512_mask_mov_epi64(u[i], positive, lesser);
            left = static_cast<__mmask8>(left | positive);
        }
        busy = left != 0;
    }
    for (std::size_t i = 0; i < vectors; ++i) _mm512_storeu_si512(odd + vector_lanes * i, u[i]);
}

}  // namespace blossom::word_gcd_lanes
