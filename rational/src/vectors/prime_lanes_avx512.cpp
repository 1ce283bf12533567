// Compiled for AVX-512 IFMA; run only where the processor has it.

// NOLINTBEGIN(portability-simd-intrinsics): elsewhere one prime is tried after the other
#include <immintrin.h>

#include "prime_lanes.hpp"

namespace blossom::prime_lanes {

namespace {

constexpr std::uint64_t digit_mask = (std::uint64_t{1} << digit_bits) - 1;

/// The digit from `bit` on; beyond the words there are zeros.
std::uint64_t digit_at(const std::uint64_t* words, std::size_t size, std::size_t bit) {
    const std::size_t word = bit / 64;
    const std::size_t shift = bit % 64;
    std::uint64_t digit = words[word] >> shift;
    if (shift > 64 - digit_bits && word + 1 < size) digit |= words[word + 1] << (64 - shift);
    return digit & digit_mask;
}

}  // namespace

/// Each lane divides by the product of its primes from the lowest digit upwards, up to the highest one. What
/// that then is less the carry is congruent to the number times a power of 2^-52 modulo the product, so that
/// it has the same primes.
std::uint32_t avx512_divisors(const Table& table, const std::uint64_t* words, std::size_t size) {
    const __m512i zero = _mm512_setzero_si512();
    const __m512i products = _mm512_load_si512(table.products);
    const __m512i inverses = _mm512_load_si512(table.inverses_of_products);
    const __m512i one = _mm512_set1_epi64(1);
    const auto digit = [&](std::size_t bit) {
        return _mm512_set1_epi64(static_cast<long long>(digit_at(words, size, bit)));
    };
    __m512i carry = zero;
    std::size_t bit = 0;
    for (; bit + digit_bits < 64 * size; bit += digit_bits) {
        const __m512i here = digit(bit);
        const __mmask8 borrow = _mm512_cmplt_epu64_mask(here, carry);
        const __m512i quotient = _mm512_madd52lo_epu64(zero, _mm512_sub_epi64(here, carry), inverses);
        carry = _mm512_madd52hi_epu64(_mm512_maskz_mov_epi64(borrow, one), quotient, products);
    }
    const __m512i rest = _mm512_abs_epi64(_mm512_sub_epi64(digit(bit), carry));
    std::uint32_t result = 0;
#pragma GCC unroll 4
    for (std::size_t i = 0; i < primes_a_lane; ++i) {
        const __m512i quotient = _mm512_madd52lo_epu64(zero, rest, _mm512_load_si512(table.inverses[i]));
        const __mmask8 divides = _mm512_cmple_epu64_mask(quotient, _mm512_load_si512(table.most[i]));
        result |= static_cast<std::uint32_t>(divides) << (lanes * i);
    }
    return result;
}

}  // namespace blossom::prime_lanes

// NOLINTEND(portability-simd-intrinsics)
