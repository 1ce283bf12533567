// Compiled for AVX-512 with 52-bit and 64-bit products and counts of leading zeros; runs only on processors
// that have them.

// NOLINTBEGIN(portability-simd-intrinsics): without these instructions, one sum is computed after the other
#include "load_eight_factors.hpp"

namespace blossom::eight_sums {

namespace {

// All arithmetic is modulo 2^64.
__m512i product(__m512i a, __m512i b) { return _mm512_mullo_epi64(a, b); }
__m512i add_product(__m512i sum, __m512i a, __m512i b) { return _mm512_add_epi64(sum, product(a, b)); }

void divide_by_common_powers(const Divisor& divisor, __m512i& top, __m512i& bottom) {
    const __m512i inverse = broadcast(divisor.inverse);
    const __m512i most = broadcast(divisor.most);
    __m512i top_quotient = product(top, inverse);
    __mmask8 divisible = _mm512_cmple_epu64_mask(top_quotient, most);
    while (divisible != 0) {
        const __m512i bottom_quotient = product(bottom, inverse);
        divisible = _mm512_mask_cmple_epu64_mask(divisible, bottom_quotient, most);
        top = _mm512_mask_mov_epi64(top, divisible, top_quotient);
        bottom = _mm512_mask_mov_epi64(bottom, divisible, bottom_quotient);
        top_quotient = product(top, inverse);
        divisible = _mm512_mask_cmple_epu64_mask(divisible, top_quotient, most);
    }
}

/// Divides both numbers by their common odd prime divisors, all of which are in `set`. The first division by
/// all of them uses the product of their inverses, so that no prime waits for another.
[[gnu::always_inline]] inline void divide_by_common_primes(const Divisor* divisors, std::uint32_t set,
                                                           __m512i& top, __m512i& bottom) {
    const __m512i one = broadcast(1);
    __m512i inverses = one;
    std::uint32_t found = 0;
    for (std::uint32_t rest = set; rest != 0; rest &= rest - 1) {
        const Divisor& divisor = divisors[__builtin_ctz(rest)];
        const __m512i inverse = broadcast(divisor.inverse);
        const __m512i most = broadcast(divisor.most);
        const __mmask8 divides = _mm512_mask_cmple_epu64_mask(
            _mm512_cmple_epu64_mask(product(bottom, inverse), most), product(top, inverse), most);
        if (divides != 0) {
            inverses = product(inverses, _mm512_mask_mov_epi64(one, divides, inverse));
            found |= rest & -rest;
        }
    }
    top = product(top, inverses);
    bottom = product(bottom, inverses);
    for (; found != 0; found &= found - 1)
        divide_by_common_powers(divisors[__builtin_ctz(found)], top, bottom);
}

template <std::size_t Count>
[[gnu::always_inline]] inline void reduced_sums(const Rows& rows, const Factor (&factors)[Count],
                                                const Divisors& divisors, std::uint32_t set,
                                                Quotients* quotients) {
    __m512i coefficients[Count + 1];
    __m512i denominator = product(broadcast(rows.denominator), factors[0].denominator);
    coefficients[0] = factors[0].constant;
    coefficients[1] = factors[0].slope;
#pragma GCC unroll 8
    for (std::size_t i = 1; i < Count; ++i) {
        const __m512i constant = factors[i].constant;
        const __m512i slope = factors[i].slope;
        denominator = product(denominator, factors[i].denominator);
        coefficients[i + 1] = product(coefficients[i], slope);
#pragma GCC unroll 8
        for (std::size_t k = i; k > 0; --k) {
            coefficients[k] = add_product(product(coefficients[k], constant), coefficients[k - 1], slope);
        }
        coefficients[0] = product(coefficients[0], constant);
    }
    const std::int64_t* row = rows.numbers;
    for (std::size_t j = 0; j < rows.rows; ++j, row += Count + 1) {
        // Two independent sums, so that neither waits for the other.
        __m512i even = _mm512_setzero_si512();
        __m512i odd = _mm512_setzero_si512();
#pragma GCC unroll 9
        for (std::size_t k = 0; k <= Count; ++k) {
            __m512i& part = k % 2 == 0 ? even : odd;
            part = add_product(part, coefficients[k], _mm512_set1_epi64(row[k]));
        }
        const __m512i sum = _mm512_add_epi64(even, odd);
        __m512i top = _mm512_abs_epi64(sum);
        __m512i bottom = denominator;
        const __m512i twos = trailing_zeros(_mm512_or_si512(top, bottom));
        top = _mm512_srlv_epi64(top, twos);
        bottom = _mm512_srlv_epi64(bottom, twos);
        divide_by_common_primes(divisors.divisors, set, top, bottom);
        const __mmask8 negative = _mm512_movepi64_mask(sum);
        _mm512_storeu_si512(quotients[j].numerators,
                            _mm512_mask_sub_epi64(top, negative, _mm512_setzero_si512(), top));
        _mm512_storeu_si512(quotients[j].denominators, bottom);
    }
}

/// A word that is nonzero if a product of one number of each factor and one of the rows may have 64 bits or
/// more. The bound counts every factor with the bits of all of them together.
template <std::size_t Count>
__m512i bits_beyond_words(std::size_t rows_bits, __m512i all) {
    const std::size_t most = rows_bits < 64 ? (63 - rows_bits) / Count : 0;
    return _mm512_srlv_epi64(all, broadcast(most));
}

template <std::size_t Count>
[[gnu::always_inline]] inline bool sums_of(const Rows& rows, const Factor (&factors)[Count], __m512i beyond,
                                           const Divisors& divisors, Quotients* quotients) {
    __m512i all = _mm512_setzero_si512();
    __m512i all_denominators = _mm512_setzero_si512();
#pragma GCC unroll 8
    for (std::size_t i = 0; i < Count; ++i) {
        all_denominators = _mm512_or_si512(all_denominators, factors[i].denominator);
        all = _mm512_or_si512(all, l1_norm(factors[i]));
    }
    all = _mm512_or_si512(all, all_denominators);
    beyond =
        _mm512_or_si512(beyond, _mm512_andnot_si512(broadcast(divisors.greatest_known), all_denominators));
    beyond = _mm512_or_si512(beyond, bits_beyond_words<Count>(rows.bits, all));
    if (_mm512_test_epi64_mask(beyond, beyond) != 0) return false;
    PrimeSets sets(divisors);
#pragma GCC unroll 8
    for (std::size_t i = 0; i < Count; ++i) sets.add(factors[i].denominator);
    const std::uint32_t set = rows.divisors | sets.all();
    if (set == ~std::uint32_t{0}) return false;
    reduced_sums<Count>(rows, factors, divisors, set, quotients);
    return true;
}

template <std::size_t Count, class Reader>
bool sums_from(const Rows& rows, Reader reader, const Divisors& divisors, Quotients* quotients) {
    Factor factors[Count];
#pragma GCC unroll 8
    for (std::size_t i = 0; i < Count; ++i) factors[i] = reader.read(i);
    return sums_of<Count>(rows, factors, reader.beyond(), divisors, quotients);
}

template <class Reader, class... Line>
bool sums_from_any(const Rows& rows, std::size_t count, const Divisors& divisors, Quotients* quotients,
                   const void* const* tuples, const Line&... line) {
    switch (count) {
        case 1:
            return sums_from<1>(rows, Reader(tuples, line...), divisors, quotients);
        case 2:
            return sums_from<2>(rows, Reader(tuples, line...), divisors, quotients);
        case 3:
            return sums_from<3>(rows, Reader(tuples, line...), divisors, quotients);
        case 4:
            return sums_from<4>(rows, Reader(tuples, line...), divisors, quotients);
        case 5:
            return sums_from<5>(rows, Reader(tuples, line...), divisors, quotients);
        case 6:
            return sums_from<6>(rows, Reader(tuples, line...), divisors, quotients);
        case 7:
            return sums_from<7>(rows, Reader(tuples, line...), divisors, quotients);
        case 8:
            return sums_from<8>(rows, Reader(tuples, line...), divisors, quotients);
        default:
            return false;
    }
}

bool sums(const Rows& rows, const void* const* tuples, std::size_t count, const WordLine* line,
          const Divisors& divisors, Quotients* quotients) {
    return line == nullptr ? sums_from_any<PairReader>(rows, count, divisors, quotients, tuples)
                           : sums_from_any<LineReader>(rows, count, divisors, quotients, tuples, *line);
}

/// Two numbers of four words each, every second of which is 0, from the lanes 2 i and 2 i + 1 of both
/// vectors.
__m512i two_numbers(__m512i even, __m512i odd, long long i) {
    const __m512i places = _mm512_set_epi64(0, 9 + 2 * i, 0, 8 + 2 * i, 0, 1 + 2 * i, 0, 2 * i);
    return _mm512_maskz_permutex2var_epi64(0x55, even, places, odd);
}

bool store(const Quotients& quotients, void* numbers) {
    auto* words = static_cast<std::int64_t*>(numbers);
    __m512i held = _mm512_loadu_si512(words);
#pragma GCC unroll 3
    for (std::size_t i = 1; i < 4; ++i) held = _mm512_or_si512(held, _mm512_loadu_si512(words + 8 * i));
    if (_mm512_mask_test_epi64_mask(0xaa, held, held) != 0) return false;
    const __m512i tops = _mm512_loadu_si512(quotients.numerators);
    const __m512i bottoms = _mm512_loadu_si512(quotients.denominators);
    const __m512i even = _mm512_unpacklo_epi64(tops, bottoms);
    const __m512i odd = _mm512_unpackhi_epi64(tops, bottoms);
    _mm512_storeu_si512(words, two_numbers(even, odd, 0));
    _mm512_storeu_si512(words + 8, two_numbers(even, odd, 1));
    _mm512_storeu_si512(words + 16, two_numbers(even, odd, 2));
    _mm512_storeu_si512(words + 24, two_numbers(even, odd, 3));
    return true;
}

}  // namespace

const Operations avx512_operations{sums, store};

}  // namespace blossom::eight_sums

// NOLINTEND(portability-simd-intrinsics)
