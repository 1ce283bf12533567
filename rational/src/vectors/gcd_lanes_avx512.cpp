#include <immintrin.h>

#include "gcd_lanes.hpp"

// NOLINTBEGIN(portability-simd-intrinsics): elsewhere one gcd is taken after the other

// The binary algorithm: while the other number is not 0, its twos are shifted out, and the two are replaced
// by the lesser one and the difference.
namespace blossom::gcd_lanes {

namespace {

constexpr std::size_t vectors = 2;
constexpr std::size_t lanes = word_pairs / vectors;

__m512i constant(long long value) { return _mm512_set1_epi64(value); }

__m512i lowest_bit(__m512i x) { return _mm512_and_si512(x, _mm512_sub_epi64(_mm512_setzero_si512(), x)); }

/// The zeros below the lowest bit, and 2^64 - 1 for 0.
__m512i trailing_zeros(__m512i x) {
    return _mm512_sub_epi64(constant(63), _mm512_lzcnt_epi64(lowest_bit(x)));
}

}  // namespace

// Two vectors in turns, because each step waits for the one before.
void avx512_gcds(std::uint64_t* odd, std::uint64_t* other) {
    __m512i u[vectors];
    __m512i v[vectors];
    for (std::size_t i = 0; i < vectors; ++i) {
        u[i] = _mm512_loadu_si512(odd + lanes * i);
        v[i] = _mm512_loadu_si512(other + lanes * i);
    }
    for (bool busy = true; busy;) {
        __mmask8 left = 0;
        for (std::size_t i = 0; i < vectors; ++i) {
            // For 0 the shift is out of range and gives 0.
            const __m512i shifted = _mm512_srlv_epi64(v[i], trailing_zeros(v[i]));
            const __mmask8 positive = _mm512_test_epi64_mask(shifted, shifted);
            const __m512i lesser = _mm512_min_epu64(u[i], shifted);
            v[i] = _mm512_maskz_sub_epi64(positive, _mm512_max_epu64(u[i], shifted), lesser);
            u[i] = _mm512_mask_mov_epi64(u[i], positive, lesser);
            left = static_cast<__mmask8>(left | positive);
        }
        busy = left != 0;
    }
    for (std::size_t i = 0; i < vectors; ++i) _mm512_storeu_si512(odd + lanes * i, u[i]);
}

}  // namespace blossom::gcd_lanes

// NOLINTEND(portability-simd-intrinsics)
