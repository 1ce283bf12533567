// Compiled for AVX-512 IFMA; runs only on processors that have it.

// NOLINTBEGIN(portability-simd-intrinsics): without these instructions integers are combined one by one
#include <immintrin.h>

#include "residue_batches.hpp"

namespace blossom::residues {

namespace {

constexpr std::size_t step = BatchTables::digits_at_once;
constexpr std::size_t digit_bits = BatchTables::digit_bits;

__m512i load(const ResidueVector& from) { return _mm512_loadu_si512(&from); }
void store(ResidueVector& to, __m512i value) { _mm512_storeu_si512(&to, value); }
__m512i broadcast(std::uint64_t value) { return _mm512_set1_epi64(static_cast<long long>(value)); }

/// Transposes eight residue vectors.
void transpose(const ResidueVector* rows, ResidueVector* columns) {
    __m512i pairs[8];
    for (std::size_t i = 0; i < 8; i += 2) {
        pairs[i] = _mm512_unpacklo_epi64(load(rows[i]), load(rows[i + 1]));
        pairs[i + 1] = _mm512_unpackhi_epi64(load(rows[i]), load(rows[i + 1]));
    }
    for (std::size_t parity = 0; parity < 2; ++parity) {
        const __m512i low = _mm512_shuffle_i64x2(pairs[parity], pairs[parity + 2], 0x88);
        const __m512i high = _mm512_shuffle_i64x2(pairs[parity], pairs[parity + 2], 0xdd);
        const __m512i further_low = _mm512_shuffle_i64x2(pairs[parity + 4], pairs[parity + 6], 0x88);
        const __m512i further_high = _mm512_shuffle_i64x2(pairs[parity + 4], pairs[parity + 6], 0xdd);
        store(columns[parity], _mm512_shuffle_i64x2(low, further_low, 0x88));
        store(columns[parity + 2], _mm512_shuffle_i64x2(high, further_high, 0x88));
        store(columns[parity + 4], _mm512_shuffle_i64x2(low, further_low, 0xdd));
        store(columns[parity + 6], _mm512_shuffle_i64x2(high, further_high, 0xdd));
    }
}

__m512i quotient(const BatchTables& tables, const ResidueVector* y) {
    constexpr unsigned fraction_bits = 49;
    __m512i sum = broadcast(std::uint64_t{1} << (fraction_bits - 1));
    for (std::size_t i = 0; i < tables.primes; ++i)
        sum = _mm512_madd52hi_epu64(sum, load(y[i]), broadcast(tables.reciprocals[i]));
    return _mm512_srli_epi64(sum, fraction_bits);
}

/// Adds the digits of the sum minus those of q M from `digit` on, without propagating carries; the upper
/// parts of products are added to the next digit.
void add_digits(const BatchTables& tables, std::size_t digit, const ResidueVector* y, __m512i q,
                ResidueVector* digits) {
    __m512i low[step];
    __m512i high[step];
    for (std::size_t d = 0; d < step; ++d) low[d] = high[d] = _mm512_setzero_si512();
    const std::uint64_t* cofactor = tables.cofactors + digit * tables.primes;
    for (std::size_t i = 0; i < tables.primes; ++i, cofactor += step) {
        const __m512i factor = load(y[i]);
#pragma GCC unroll 8
        for (std::size_t d = 0; d < step; ++d) {
            const __m512i other = broadcast(cofactor[d]);
            low[d] = _mm512_madd52lo_epu64(low[d], factor, other);
            high[d] = _mm512_madd52hi_epu64(high[d], factor, other);
        }
    }
    const __m512i zero = _mm512_setzero_si512();
    for (std::size_t d = 0; d < step; ++d) {
        const __m512i other = broadcast(tables.product[digit + d]);
        low[d] = _mm512_sub_epi64(low[d], _mm512_madd52lo_epu64(zero, q, other));
        high[d] = _mm512_sub_epi64(high[d], _mm512_madd52hi_epu64(zero, q, other));
        ResidueVector& own = digits[digit + d];
        store(own, _mm512_add_epi64(load(own), low[d]));
        store(digits[digit + d + 1], high[d]);
    }
}

/// Propagates carries so that all digits are below 2^52 except the top one, which has the sign; the excess
/// cancels.
void carry(ResidueVector* digits, std::size_t count) {
    const __m512i mask = broadcast((std::uint64_t{1} << digit_bits) - 1);
    __m512i carried = _mm512_setzero_si512();
    for (std::size_t d = 0; d + 1 < count; ++d) {
        const __m512i digit = _mm512_add_epi64(load(digits[d]), carried);
        carried = _mm512_srai_epi64(digit, digit_bits);
        store(digits[d], _mm512_and_si512(digit, mask));
    }
    constexpr unsigned unused_bits = 64 - digit_bits;
    const __m512i wrapped = _mm512_add_epi64(load(digits[count - 1]), carried);
    const __m512i greatest = _mm512_srai_epi64(_mm512_slli_epi64(wrapped, unused_bits), unused_bits);
    store(digits[count - 1], greatest);
    // The sign extension, for words that reach beyond the top digit.
    store(digits[count], _mm512_srai_epi64(greatest, 63));
    store(digits[count + 1], _mm512_srai_epi64(greatest, 63));
}

/// A word, which has bits of two or three digits.
__m512i word(const ResidueVector* digits, std::size_t index) {
    const std::size_t first = index * 64 / digit_bits;
    const std::size_t offset = index * 64 % digit_bits;
    const auto distance = [](std::size_t bits) { return _mm_cvtsi64_si128(static_cast<long long>(bits)); };
    const __m512i low = _mm512_sra_epi64(load(digits[first]), distance(offset));
    const __m512i middle = _mm512_sll_epi64(load(digits[first + 1]), distance(digit_bits - offset));
    const __m512i high = _mm512_sll_epi64(load(digits[first + 2]), distance(2 * digit_bits - offset));
    return _mm512_or_si512(_mm512_or_si512(low, middle), high);
}

}  // namespace

void avx512_integers_of_residues(const BatchTables& tables, const ResidueVector* numbers, std::size_t stride,
                                 ResidueVector* room, ResidueVector* words) {
    ResidueVector* const y = room;
    ResidueVector* const digits = room + tables.primes;
    for (std::size_t i = 0; i < tables.primes; i += 8) transpose(numbers + i / 8 * stride, y + i);
    const __m512i q = quotient(tables, y);
    store(digits[0], _mm512_setzero_si512());
    for (std::size_t digit = 0; digit < tables.digits; digit += step) add_digits(tables, digit, y, q, digits);
    carry(digits, tables.digits);
    for (std::size_t i = 0; i < tables.words; ++i) store(words[i], word(digits, i));
}

}  // namespace blossom::residues

// NOLINTEND(portability-simd-intrinsics)
