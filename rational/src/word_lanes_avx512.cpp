// Compiled for AVX-512 with 52-bit and 64-bit products and leading zeros; run only where the processor has
// them.

// NOLINTBEGIN(portability-simd-intrinsics): what has no lanes computes one sum after the other
#include <immintrin.h>

#include "word_lanes.hpp"

namespace blossom::word_lanes {

namespace {

__m512i load(const std::int64_t* words) { return _mm512_load_si512(words); }

__m512i broadcast(std::uint64_t word) { return _mm512_set1_epi64(static_cast<long long>(word)); }

/// Numbers modulo 2^64.
struct Full {
    static constexpr std::size_t bits = 64;
    static __m512i add_product(__m512i sum, __m512i a, __m512i b) {
        return _mm512_add_epi64(sum, _mm512_mullo_epi64(a, b));
    }
    static __m512i number(__m512i residue) { return residue; }
    static __m512i most(std::uint64_t quotient) { return broadcast(quotient); }
};

/// Numbers modulo 2^52, in the lower bits of their lanes: products take a third of the time.
struct Short {
    static constexpr std::size_t bits = 52;
    static __m512i add_product(__m512i sum, __m512i a, __m512i b) { return _mm512_madd52lo_epu64(sum, a, b); }
    static __m512i number(__m512i residue) {
        return _mm512_srai_epi64(_mm512_slli_epi64(residue, 64 - bits), 64 - bits);
    }
    static __m512i most(std::uint64_t quotient) { return broadcast(quotient >> (64 - bits)); }
};

template <class Numbers>
__m512i product(__m512i a, __m512i b) {
    return Numbers::add_product(_mm512_setzero_si512(), a, b);
}

std::size_t width(std::uint64_t word) {
    return word == 0 ? 0 : 64 - static_cast<std::size_t>(__builtin_clzll(word));
}

template <class Numbers>
void divide_by_common_powers(const Divisor& divisor, __m512i& top, __m512i& bottom) {
    const __m512i inverse = broadcast(divisor.inverse);
    const __m512i most = Numbers::most(divisor.most);
    __m512i top_quotient = product<Numbers>(top, inverse);
    __mmask8 divisible = _mm512_cmple_epu64_mask(top_quotient, most);
    while (divisible != 0) {
        const __m512i bottom_quotient = product<Numbers>(bottom, inverse);
        divisible = _mm512_mask_cmple_epu64_mask(divisible, bottom_quotient, most);
        top = _mm512_mask_mov_epi64(top, divisible, top_quotient);
        bottom = _mm512_mask_mov_epi64(bottom, divisible, bottom_quotient);
        top_quotient = product<Numbers>(top, inverse);
        divisible = _mm512_mask_cmple_epu64_mask(divisible, top_quotient, most);
    }
}

/// The numbers of zeros behind the lowest bit set.
__m512i trailing_zeros(__m512i words) {
    const __m512i lowest = _mm512_and_si512(words, _mm512_sub_epi64(_mm512_setzero_si512(), words));
    return _mm512_sub_epi64(broadcast(63), _mm512_lzcnt_epi64(lowest));
}

/// The divisors of all lanes; all bits if one is beyond the table.
std::uint32_t divisors_of(const Divisors& divisors, __m512i numbers) {
    const __m512i odd = _mm512_srlv_epi64(numbers, trailing_zeros(numbers));
    if (_mm512_cmpgt_epu64_mask(odd, broadcast(divisors.greatest_known)) != 0) return ~std::uint32_t{0};
    const __m256i sets = _mm512_i64gather_epi32(_mm512_srli_epi64(odd, 1), divisors.of_odd, 4);
    return static_cast<std::uint32_t>(_mm512_reduce_or_epi32(_mm512_zextsi256_si512(sets)));
}

template <std::size_t Count, class Numbers>
void reduced_sums(const Rows& rows, const WordFactorOctet* factors, const Divisors& divisors,
                  std::uint32_t set, Quotients* sums) {
    __m512i coefficients[Count + 1];
    __m512i denominator = broadcast(rows.denominator);
    coefficients[0] = broadcast(1);
#pragma GCC unroll 8
    for (std::size_t i = 0; i < Count; ++i) {
        const __m512i constant = load(factors[i].constants);
        const __m512i slope = load(factors[i].slopes);
        denominator = product<Numbers>(denominator, load(factors[i].denominators));
        coefficients[i + 1] = product<Numbers>(coefficients[i], slope);
#pragma GCC unroll 8
        for (std::size_t k = i; k > 0; --k) {
            coefficients[k] =
                Numbers::add_product(product<Numbers>(coefficients[k], constant), coefficients[k - 1], slope);
        }
        coefficients[0] = product<Numbers>(coefficients[0], constant);
    }
    const std::int64_t* row = rows.numbers;
    for (std::size_t j = 0; j < rows.rows; ++j, row += Count + 1) {
        __m512i sum = _mm512_setzero_si512();
#pragma GCC unroll 9
        for (std::size_t k = 0; k <= Count; ++k)
            sum = Numbers::add_product(sum, coefficients[k], _mm512_set1_epi64(row[k]));
        sum = Numbers::number(sum);
        __m512i top = _mm512_abs_epi64(sum);
        __m512i bottom = denominator;
        const __m512i twos = trailing_zeros(_mm512_or_si512(top, bottom));
        top = _mm512_srlv_epi64(top, twos);
        bottom = _mm512_srlv_epi64(bottom, twos);
        for (std::uint32_t rest = set; rest != 0; rest &= rest - 1)
            divide_by_common_powers<Numbers>(divisors.divisors[__builtin_ctz(rest)], top, bottom);
        const __mmask8 negative = _mm512_movepi64_mask(sum);
        _mm512_store_si512(sums[j].numerators,
                           _mm512_mask_sub_epi64(top, negative, _mm512_setzero_si512(), top));
        _mm512_store_si512(sums[j].denominators, bottom);
    }
}

template <std::size_t Count>
bool sums_of(const Rows& rows, const WordFactorOctet* factors, const Divisors& divisors, Quotients* sums) {
    std::uint32_t set = rows.divisors;
    __m512i sizes = _mm512_setzero_si512();
    __m512i denominators = _mm512_setzero_si512();
#pragma GCC unroll 8
    for (std::size_t i = 0; i < Count; ++i) {
        const __m512i denominator = load(factors[i].denominators);
        set |= divisors_of(divisors, denominator);
        denominators = _mm512_or_si512(denominators, denominator);
        sizes = _mm512_or_si512(sizes, _mm512_add_epi64(_mm512_abs_epi64(load(factors[i].constants)),
                                                        _mm512_abs_epi64(load(factors[i].slopes))));
    }
    if (set == ~std::uint32_t{0}) return false;
    // The bits of a product of one number of each octet, bounded by those of all numbers together.
    const auto bits = [](__m512i all, std::uint64_t further) {
        return Count * width(static_cast<std::uint64_t>(_mm512_reduce_or_epi64(all))) + width(further);
    };
    const std::size_t top = bits(sizes, rows.greatest);
    const std::size_t bottom = bits(denominators, rows.denominator);
    const std::size_t most = top > bottom ? top : bottom;
    if (most < Short::bits) {
        reduced_sums<Count, Short>(rows, factors, divisors, set, sums);
    } else if (most < Full::bits) {
        reduced_sums<Count, Full>(rows, factors, divisors, set, sums);
    }
    return most < Full::bits;
}

}  // namespace

bool avx512_sums(const Rows& rows, const WordFactorOctet* factors, std::size_t count,
                 const Divisors& divisors, Quotients* sums) {
    switch (count) {
        case 1:
            return sums_of<1>(rows, factors, divisors, sums);
        case 2:
            return sums_of<2>(rows, factors, divisors, sums);
        case 3:
            return sums_of<3>(rows, factors, divisors, sums);
        case 4:
            return sums_of<4>(rows, factors, divisors, sums);
        case 5:
            return sums_of<5>(rows, factors, divisors, sums);
        case 6:
            return sums_of<6>(rows, factors, divisors, sums);
        case 7:
            return sums_of<7>(rows, factors, divisors, sums);
        case 8:
            return sums_of<8>(rows, factors, divisors, sums);
        default:
            return false;
    }
}

}  // namespace blossom::word_lanes

// NOLINTEND(portability-simd-intrinsics)
