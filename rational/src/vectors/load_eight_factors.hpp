#pragma once

// Reads factors into vector lanes; only for sources compiled for AVX-512 with 64-bit products.

// NOLINTBEGIN(portability-simd-intrinsics): without these instructions, one sum is computed after the other
#include <immintrin.h>

#include "eight_sums.hpp"
#include "factor_lanes.hpp"

namespace blossom::eight_sums {

namespace {

using factor_lanes::Factor;
using factor_lanes::l1_norm;
using factor_lanes::united;

inline __m512i broadcast(std::uint64_t word) { return _mm512_set1_epi64(static_cast<long long>(word)); }

/// The words of a pair of numbers u, m for the factor m + u X: u and m as numerator and denominator, each of
/// these as a word and an address that is nonzero if the value is not a word.
inline constexpr std::size_t pair_words = 8;

/// From the bitwise or of all pairs, the bits that are 0 if every u is a quotient of words and every m is 0
/// or 1: all bits except those of the words of u and the lowest bits of the words of m, whose denominator is
/// then 1.
inline __m512i surplus(__m512i all_pairs) {
    return _mm512_and_si512(all_pairs, _mm512_set_epi64(-1, ~1LL, -1, ~1LL, -1, 0, -1, 0));
}

/// The factors of eight pairs.
[[gnu::always_inline]] inline Factor factors_of(const __m512i (&pairs)[lanes]) {
    // The even words of two pairs: numerators and denominators of u, then of m, each 128 bits.
    __m512i twos[4];
#pragma GCC unroll 4
    for (std::size_t i = 0; i < 4; ++i) twos[i] = _mm512_unpacklo_epi64(pairs[2 * i], pairs[2 * i + 1]);
    constexpr int lower = 0x44;        // the first and second 128 bits of both operands
    constexpr int third = 0xaa;        // the third 128 bits
    constexpr int odd_places = 0x88;   // the first and third 128 bits
    constexpr int even_places = 0xdd;  // the second and fourth 128 bits
    const __m512i front = _mm512_shuffle_i64x2(twos[0], twos[1], lower);
    const __m512i back = _mm512_shuffle_i64x2(twos[2], twos[3], lower);
    const __m512i masses = _mm512_shuffle_i64x2(_mm512_shuffle_i64x2(twos[0], twos[1], third),
                                                _mm512_shuffle_i64x2(twos[2], twos[3], third), odd_places);
    const __m512i slopes = _mm512_shuffle_i64x2(front, back, odd_places);
    const __m512i denominators = _mm512_shuffle_i64x2(front, back, even_places);
    const __m512i all_or_nothing = _mm512_sub_epi64(_mm512_setzero_si512(), masses);
    return {_mm512_and_si512(denominators, all_or_nothing), slopes, denominators};
}

/// Reads factors m + u X.
class PairReader {
public:
    explicit PairReader(const void* const* tuples) : tuples_(tuples) {}

    /// Factor i of all tuples.
    [[gnu::always_inline]] Factor read(std::size_t i) {
        __m512i pairs[lanes];
#pragma GCC unroll 8
        for (std::size_t l = 0; l < lanes; ++l) {
            pairs[l] = _mm512_loadu_si512(static_cast<const std::uint64_t*>(tuples_[l]) + pair_words * i);
            all_ = _mm512_or_si512(all_, pairs[l]);
        }
        return factors_of(pairs);
    }

    /// Bits that are all 0 if every u read so far is a quotient of words and every m is 0 or 1.
    __m512i beyond() const { return surplus(all_); }

private:
    const void* const* tuples_;
    __m512i all_ = _mm512_setzero_si512();
};

/// Reads factors m + u X over another line.
class LineReader {
public:
    LineReader(const void* const* tuples, const WordLine& line)
        : pairs_(tuples),
          a_(_mm512_set1_epi64(line.a)),
          b_(_mm512_set1_epi64(line.b)),
          q_(_mm512_set1_epi64(line.q)),
          length_(_mm512_set1_epi64(line.length)) {}

    [[gnu::always_inline]] Factor read(std::size_t i) {
        // Products of signed 32-bit numbers; the sum of two of them is below 2^63.
        const Factor factor = pairs_.read(i);
        const __m512i x = _mm512_mul_epi32(q_, factor.slope);
        const __m512i from_a = _mm512_mul_epi32(a_, factor.constant);
        const __m512i to_b = _mm512_mul_epi32(b_, factor.constant);
        all_ = _mm512_or_si512(all_, _mm512_abs_epi64(factor.slope));
        all_ = _mm512_or_si512(all_, factor.denominator);
        return {_mm512_sub_epi64(to_b, x), _mm512_sub_epi64(x, from_a),
                _mm512_mul_epi32(length_, factor.denominator)};
    }

    /// The same, and every number is a signed number of 32 bits.
    __m512i beyond() const { return _mm512_or_si512(pairs_.beyond(), _mm512_srli_epi64(all_, 31)); }

private:
    PairReader pairs_;
    __m512i a_;
    __m512i b_;
    __m512i q_;
    __m512i length_;
    __m512i all_ = _mm512_setzero_si512();
};

/// The number of zeros below the lowest set bit of each word.
inline __m512i trailing_zeros(__m512i words) {
    const __m512i lowest = _mm512_and_si512(words, _mm512_sub_epi64(_mm512_setzero_si512(), words));
    return _mm512_sub_epi64(broadcast(63), _mm512_lzcnt_epi64(lowest));
}

/// The sets of prime divisors of denominators up to the greatest known.
class PrimeSets {
public:
    explicit PrimeSets(const Divisors& divisors) : of_(divisors.of) {}

    void add(__m512i denominators) {
        sets_ = _mm256_or_si256(sets_, _mm512_i64gather_epi32(denominators, of_, 4));
    }
    std::uint32_t all() const {
        const std::uint64_t two = united(_mm512_zextsi256_si512(sets_));
        return static_cast<std::uint32_t>(two | two >> 32);
    }

private:
    const std::uint32_t* of_;
    __m256i sets_ = _mm256_setzero_si256();
};

}  // namespace

}  // namespace blossom::eight_sums

// NOLINTEND(portability-simd-intrinsics)
