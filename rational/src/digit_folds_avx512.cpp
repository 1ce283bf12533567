// Compiled for AVX-512 IFMA; run only where the processor has it.

// NOLINTBEGIN(portability-simd-intrinsics): elsewhere rows of limbs take its place
#include <immintrin.h>

#include "digit_folds.hpp"

namespace blossom::digit_folds {

namespace {

constexpr std::size_t lanes = 8;
constexpr std::uint64_t mask = (std::uint64_t{1} << digit_bits) - 1;

__m512i load(const std::uint64_t* from) { return _mm512_loadu_si512(from); }

/// All ones where a digit at the top says that its number is negative.
__m512i extension(__m512i top) {
    const __m512i sign = _mm512_srai_epi64(_mm512_slli_epi64(top, 64 - digit_bits), 63);
    return _mm512_and_si512(sign, _mm512_set1_epi64(mask));
}

/// Eight sums at a time. A coefficient is taken modulo 2^52, where a negative one is 2^52 too large, which is
/// subtracted one digit further up. Each term adds less than 2^52 to one of the sums of 64 bits.
template <std::size_t Digits>
void fold_block(const std::uint64_t* numbers, std::size_t count, const Block& block, std::uint64_t* sums) {
    const __m512i digit_mask = _mm512_set1_epi64(mask);
    for (std::size_t i = 0; i < count; i += lanes) {
        __m512i low[Digits];
        __m512i high[Digits];
#pragma GCC unroll 16
        for (std::size_t d = 0; d < Digits; ++d) low[d] = high[d] = _mm512_setzero_si512();
        for (std::size_t j = 0; j <= block.degree; ++j) {
            const std::int64_t value = block.coefficients[j];
            const __m512i coefficient = _mm512_set1_epi64(value);
            const auto negative = static_cast<__mmask8>(value >> 63);
            const std::uint64_t* const terms = numbers + i + j;
#pragma GCC unroll 16
            for (std::size_t d = 0; d < Digits; ++d) {
                const __m512i term = load(terms + d * most_stride);
                low[d] = _mm512_madd52lo_epu64(low[d], term, coefficient);
                if (d + 1 < Digits) {
                    high[d] = _mm512_madd52hi_epu64(high[d], term, coefficient);
                    high[d] = _mm512_mask_sub_epi64(high[d], negative, high[d], term);
                }
            }
        }
        __m512i carry = _mm512_setzero_si512();
#pragma GCC unroll 16
        for (std::size_t d = 0; d < Digits; ++d) {
            __m512i sum = _mm512_add_epi64(low[d], carry);
            if (d > 0) sum = _mm512_add_epi64(sum, high[d - 1]);
            carry = _mm512_srai_epi64(sum, digit_bits);
            _mm512_storeu_si512(sums + d * most_stride + i, _mm512_and_si512(sum, digit_mask));
        }
    }
}

using FoldBlock = void (*)(const std::uint64_t*, std::size_t, const Block&, std::uint64_t*);
constexpr FoldBlock fold_blocks[] = {
    fold_block<1>,  fold_block<2>,  fold_block<3>,  fold_block<4>,  fold_block<5>,  fold_block<6>,
    fold_block<7>,  fold_block<8>,  fold_block<9>,  fold_block<10>, fold_block<11>, fold_block<12>,
    fold_block<13>, fold_block<14>, fold_block<15>, fold_block<16>,
};

/// The digits above those that the numbers have.
void extend(std::uint64_t* numbers, std::size_t count, std::size_t from, std::size_t to) {
    for (; from < to; ++from) {
        for (std::size_t i = 0; i < count; i += lanes) {
            const std::uint64_t* const top = numbers + (from - 1) * most_stride + i;
            _mm512_storeu_si512(numbers + from * most_stride + i, extension(load(top)));
        }
    }
}

}  // namespace

void avx512_fold(const Columns& numbers, const Block* blocks, std::size_t block_count, std::uint64_t* sum) {
    // What is read behind the last number of a row is not used.
    alignas(64) std::uint64_t rows[2][most_digits * most_stride];
    std::uint64_t* from = rows[0];
    std::uint64_t* to = rows[1];
    const std::size_t padded = (numbers.count + 2 * lanes - 1) / lanes * lanes;
    for (std::size_t d = 0; d < numbers.digits; ++d) {
        for (std::size_t k = 0; k < padded; k += lanes) {
            _mm512_storeu_si512(from + d * most_stride + k,
                                load(numbers.digits_of_all + d * numbers.stride + k));
        }
    }
    std::size_t count = numbers.count;
    std::size_t digits = numbers.digits;
    for (std::size_t b = 0; b < block_count; ++b) {
        const Block& block = blocks[b];
        extend(from, count, digits, block.digits);
        count -= block.degree;
        fold_blocks[block.digits - 1](from, count, block, to);
        digits = block.digits;
        std::uint64_t* const other = from;
        from = to;
        to = other;
    }
    for (std::size_t d = 0; d < digits; ++d) sum[d] = from[d * most_stride];
}

}  // namespace blossom::digit_folds

// NOLINTEND(portability-simd-intrinsics)
