// Compiled for AVX-512 with 64-bit products and leading zeros; run only where the processor has them.

// NOLINTBEGIN(portability-simd-intrinsics): what has no lanes computes one sum after the other
#include <immintrin.h>

#include "word_lanes.hpp"

namespace blossom::word_lanes {

namespace {

__m512i load(const std::int64_t* words) { return _mm512_load_si512(words); }

__m512i broadcast(std::uint64_t word) { return _mm512_set1_epi64(static_cast<long long>(word)); }

std::size_t width(std::uint64_t word) {
    return word == 0 ? 0 : 64 - static_cast<std::size_t>(__builtin_clzll(word));
}

/// Whether the product of one number of each octet and `further` stays below 2^63 in all lanes; `all` has the
/// bits of all numbers.
bool fits(__m512i all, std::size_t count, std::uint64_t further) {
    return count * width(static_cast<std::uint64_t>(_mm512_reduce_or_epi64(all))) + width(further) <= 63;
}

void divide_by_common_powers(const Divisor& divisor, __m512i& top, __m512i& bottom) {
    const __m512i inverse = broadcast(divisor.inverse);
    const __m512i most = broadcast(divisor.most);
    __m512i top_quotient = _mm512_mullo_epi64(top, inverse);
    __mmask8 divisible = _mm512_cmple_epu64_mask(top_quotient, most);
    while (divisible != 0) {
        const __m512i bottom_quotient = _mm512_mullo_epi64(bottom, inverse);
        divisible = _mm512_mask_cmple_epu64_mask(divisible, bottom_quotient, most);
        top = _mm512_mask_mov_epi64(top, divisible, top_quotient);
        bottom = _mm512_mask_mov_epi64(bottom, divisible, bottom_quotient);
        top_quotient = _mm512_mullo_epi64(top, inverse);
        divisible = _mm512_mask_cmple_epu64_mask(divisible, top_quotient, most);
    }
}

template <std::size_t Count>
bool sums_of(const Rows& rows, const WordFactorOctet* factors, const Divisor* divisors,
             std::size_t divisor_count, Quotients* sums) {
    __m512i sizes = _mm512_setzero_si512();
    __m512i all_denominators = sizes;
    __m512i product[Count + 1];
    __m512i denominator = broadcast(rows.denominator);
    product[0] = broadcast(1);
#pragma GCC unroll 8
    for (std::size_t i = 0; i < Count; ++i) {
        const __m512i constant = load(factors[i].constants);
        const __m512i slope = load(factors[i].slopes);
        const __m512i below = load(factors[i].denominators);
        const __m512i size = _mm512_add_epi64(_mm512_abs_epi64(constant), _mm512_abs_epi64(slope));
        sizes = _mm512_or_si512(sizes, size);
        all_denominators = _mm512_or_si512(all_denominators, below);
        denominator = _mm512_mullo_epi64(denominator, below);
        product[i + 1] = _mm512_mullo_epi64(product[i], slope);
#pragma GCC unroll 8
        for (std::size_t k = i; k > 0; --k) {
            product[k] = _mm512_add_epi64(_mm512_mullo_epi64(product[k], constant),
                                          _mm512_mullo_epi64(product[k - 1], slope));
        }
        product[0] = _mm512_mullo_epi64(product[0], constant);
    }
    if (!fits(sizes, Count, rows.greatest) || !fits(all_denominators, Count, rows.denominator)) return false;

    const std::int64_t* row = rows.numbers;
    for (std::size_t j = 0; j < rows.rows; ++j, row += Count + 1) {
        __m512i sum = _mm512_setzero_si512();
#pragma GCC unroll 9
        for (std::size_t k = 0; k <= Count; ++k)
            sum = _mm512_add_epi64(sum, _mm512_mullo_epi64(product[k], _mm512_set1_epi64(row[k])));
        __m512i top = _mm512_abs_epi64(sum);
        __m512i bottom = denominator;
        const __m512i both = _mm512_or_si512(top, bottom);
        const __m512i lowest = _mm512_and_si512(both, _mm512_sub_epi64(_mm512_setzero_si512(), both));
        const __m512i twos = _mm512_sub_epi64(broadcast(63), _mm512_lzcnt_epi64(lowest));
        top = _mm512_srlv_epi64(top, twos);
        bottom = _mm512_srlv_epi64(bottom, twos);
        for (std::size_t i = 0; i < divisor_count; ++i) divide_by_common_powers(divisors[i], top, bottom);
        const __mmask8 negative = _mm512_movepi64_mask(sum);
        _mm512_store_si512(sums[j].numerators,
                           _mm512_mask_sub_epi64(top, negative, _mm512_setzero_si512(), top));
        _mm512_store_si512(sums[j].denominators, bottom);
    }
    return true;
}

}  // namespace

bool avx512_sums(const Rows& rows, const WordFactorOctet* factors, std::size_t count, const Divisor* divisors,
                 std::size_t divisor_count, Quotients* sums) {
    switch (count) {
        case 1:
            return sums_of<1>(rows, factors, divisors, divisor_count, sums);
        case 2:
            return sums_of<2>(rows, factors, divisors, divisor_count, sums);
        case 3:
            return sums_of<3>(rows, factors, divisors, divisor_count, sums);
        case 4:
            return sums_of<4>(rows, factors, divisors, divisor_count, sums);
        case 5:
            return sums_of<5>(rows, factors, divisors, divisor_count, sums);
        case 6:
            return sums_of<6>(rows, factors, divisors, divisor_count, sums);
        case 7:
            return sums_of<7>(rows, factors, divisors, divisor_count, sums);
        case 8:
            return sums_of<8>(rows, factors, divisors, divisor_count, sums);
        default:
            return false;
    }
}

}  // namespace blossom::word_lanes

// NOLINTEND(portability-simd-intrinsics)
