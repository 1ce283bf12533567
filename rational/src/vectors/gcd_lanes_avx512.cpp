#include <immintrin.h>

#include "gcd_lanes.hpp"

// NOLINTBEGIN(portability-simd-intrinsics): without these instructions, one gcd is computed after the other

// The binary algorithm: while the other number is not 0, its factors of two are removed, and the two numbers
// are replaced by the smaller one and their difference.
namespace blossom::gcd_lanes {

namespace {

constexpr std::size_t vectors = 2;
constexpr std::size_t lanes = word_pairs / vectors;

__m512i constant(long long value) { return _mm512_set1_epi64(value); }

__m512i lowest_bit(__m512i x) { return _mm512_and_si512(x, _mm512_sub_epi64(_mm512_setzero_si512(), x)); }

/// The number of zeros below the lowest set bit; 2^64 - 1 for 0.
__m512i trailing_zeros(__m512i x) {
    return _mm512_sub_epi64(constant(63), _mm512_lzcnt_epi64(lowest_bit(x)));
}

bool is_zero(__m512i x) { return _mm512_test_epi64_mask(x, x) == 0; }

/// Eight numbers of a fixed number of digits.
template <std::size_t Digits>
struct Numbers {
    __m512i digits[Digits] = {};

    bool are_zero() const {
        __m512i any = digits[0];
        for (std::size_t i = 1; i < Digits; ++i) any = _mm512_or_si512(any, digits[i]);
        return is_zero(any);
    }
    /// Removes factors of two found in the lowest digit: a whole digit if that is 0.
    void shift_twos_out() {
        const __m512i all = constant(digit_bits);
        const __m512i mask = constant((1LL << digit_bits) - 1);
        const __m512i shift = _mm512_min_epu64(trailing_zeros(digits[0]), all);
        const __m512i rest = _mm512_sub_epi64(all, shift);
        for (std::size_t i = 0; i + 1 < Digits; ++i) {
            const __m512i high = _mm512_sllv_epi64(digits[i + 1], rest);
            digits[i] = _mm512_and_si512(_mm512_or_si512(_mm512_srlv_epi64(digits[i], shift), high), mask);
        }
        digits[Digits - 1] = _mm512_srlv_epi64(digits[Digits - 1], shift);
    }
};

/// One step for numbers of several digits.
template <std::size_t Digits>
void step(Numbers<Digits>& odd, Numbers<Digits>& other) {
    const __m512i zero = _mm512_setzero_si512();
    const __m512i mask = constant((1LL << digit_bits) - 1);
    other.shift_twos_out();
    __m512i difference[Digits];
    __m512i negative[Digits];
    __m512i borrow = zero;
    __m512i carry = zero;
    for (std::size_t i = 0; i < Digits; ++i) {
        const __m512i digit = _mm512_sub_epi64(other.digits[i], odd.digits[i]);
        const __m512i below = _mm512_add_epi64(digit, borrow);
        const __m512i above = _mm512_sub_epi64(carry, digit);
        difference[i] = _mm512_and_si512(below, mask);
        negative[i] = _mm512_and_si512(above, mask);
        borrow = _mm512_srai_epi64(below, digit_bits);
        carry = _mm512_srai_epi64(above, digit_bits);
    }
    // A number whose lowest digit was 0 may still be even; it waits for the next step.
    const __mmask8 ready = _mm512_test_epi64_mask(other.digits[0], constant(1));
    const __mmask8 less = _mm512_mask_cmplt_epi64_mask(ready, borrow, zero);
    for (std::size_t i = 0; i < Digits; ++i) {
        odd.digits[i] = _mm512_mask_mov_epi64(odd.digits[i], less, other.digits[i]);
        const __m512i next = _mm512_mask_mov_epi64(other.digits[i], ready, difference[i]);
        other.digits[i] = _mm512_mask_mov_epi64(next, less, negative[i]);
    }
}

/// The gcds are returned in `odd`. The numbers are shortened by a digit when all of them allow it.
template <std::size_t Digits>
void run(Numbers<Digits>& odd, Numbers<Digits>& other) {
    while (!other.are_zero()) {
        if constexpr (Digits > 1) {
            if (is_zero(_mm512_or_si512(odd.digits[Digits - 1], other.digits[Digits - 1]))) {
                Numbers<Digits - 1> shorter_odd;
                Numbers<Digits - 1> shorter_other;
                for (std::size_t i = 0; i + 1 < Digits; ++i) {
                    shorter_odd.digits[i] = odd.digits[i];
                    shorter_other.digits[i] = other.digits[i];
                }
                run(shorter_odd, shorter_other);
                for (std::size_t i = 0; i + 1 < Digits; ++i) odd.digits[i] = shorter_odd.digits[i];
                return;
            }
        }
        step(odd, other);
    }
}

/// Numbers congruent to `number` times a power of 2^-52 modulo the factors, and not above them: the digits of
/// the number are eliminated from the lowest upwards. Sums stay in 64 bits, of which each digit needs few
/// more than 52.
template <std::size_t Digits>
Numbers<Digits> remainders(const std::uint64_t* number, std::size_t count, const Numbers<Digits>& factors,
                           __m512i negative_inverses) {
    const __m512i zero = _mm512_setzero_si512();
    Numbers<Digits> rest;
    for (__m512i& digit : rest.digits) digit = zero;
    for (std::size_t j = 0; j < count; ++j) {
        const __m512i lowest = _mm512_add_epi64(rest.digits[0], constant(static_cast<long long>(number[j])));
        const __m512i quotient = _mm512_madd52lo_epu64(zero, lowest, negative_inverses);
        const __m512i cleared = _mm512_madd52lo_epu64(lowest, quotient, factors.digits[0]);
        for (std::size_t i = 0; i + 1 < Digits; ++i) {
            const __m512i low = _mm512_madd52lo_epu64(rest.digits[i + 1], quotient, factors.digits[i + 1]);
            rest.digits[i] = _mm512_madd52hi_epu64(low, quotient, factors.digits[i]);
        }
        rest.digits[Digits - 1] = _mm512_madd52hi_epu64(zero, quotient, factors.digits[Digits - 1]);
        rest.digits[0] = _mm512_add_epi64(rest.digits[0], _mm512_srli_epi64(cleared, digit_bits));
    }
    const __m512i mask = constant((1LL << digit_bits) - 1);
    for (std::size_t i = 0; i + 1 < Digits; ++i) {
        const __m512i carry = _mm512_srli_epi64(rest.digits[i], digit_bits);
        rest.digits[i + 1] = _mm512_add_epi64(rest.digits[i + 1], carry);
        rest.digits[i] = _mm512_and_si512(rest.digits[i], mask);
    }
    return rest;
}

/// For factors of at most `Digits` digits.
template <std::size_t Digits>
void gcds(const std::uint64_t* number, std::size_t count, Factors& given) {
    Numbers<Digits> odd;
    for (std::size_t i = 0; i < Digits; ++i) odd.digits[i] = _mm512_loadu_si512(given.digits[i]);
    if constexpr (Digits > 1) {
        if (is_zero(odd.digits[Digits - 1])) return gcds<Digits - 1>(number, count, given);
    }
    Numbers<Digits> rest = remainders(number, count, odd, _mm512_loadu_si512(given.negative_inverses));
    run(odd, rest);
    for (std::size_t i = 0; i < Digits; ++i) _mm512_storeu_si512(given.digits[i], odd.digits[i]);
}

// Two vectors in alternation, because each step waits for the previous one.
void word_gcds(std::uint64_t* odd, std::uint64_t* other) {
    __m512i u[vectors];
    __m512i v[vectors];
    for (std::size_t i = 0; i < vectors; ++i) {
        u[i] = _mm512_loadu_si512(odd + lanes * i);
        v[i] = _mm512_loadu_si512(other + lanes * i);
    }
    for (bool busy = true; busy;) {
        __mmask8 left = 0;
        for (std::size_t i = 0; i < vectors; ++i) {
            // For 0 the shift is out of range, and the result is 0.
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

}  // namespace

const Operations avx512_operations{word_gcds, gcds<most_digits>};

}  // namespace blossom::gcd_lanes

// NOLINTEND(portability-simd-intrinsics)
