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

/// Numbers in digits, those of one place `stride` after those of the place before.
struct Rows {
    const std::uint64_t* digits;
    std::size_t stride;
};

/// Sums of products, eight at a time, modulo 2^52 to the digits. A coefficient is taken modulo 2^52, where a
/// negative one is 2^52 too large, which is subtracted one digit further up. Each term adds less than 2^52 to
/// one of the sums of 64 bits.
template <std::size_t Digits>
class Sums {
public:
    [[gnu::always_inline]] Sums() {
#pragma GCC unroll 16
        for (std::size_t d = 0; d < Digits; ++d) low_[d] = high_[d] = _mm512_setzero_si512();
    }
    [[gnu::always_inline]] void add(const Rows& numbers, __m512i coefficients, __mmask8 negative) {
#pragma GCC unroll 16
        for (std::size_t d = 0; d < Digits; ++d) {
            const __m512i term = load(numbers.digits + d * numbers.stride);
            low_[d] = _mm512_madd52lo_epu64(low_[d], term, coefficients);
            if (d + 1 < Digits) {
                high_[d] = _mm512_madd52hi_epu64(high_[d], term, coefficients);
                high_[d] = _mm512_mask_sub_epi64(high_[d], negative, high_[d], term);
            }
        }
    }
    /// With carries that were not passed on.
    [[gnu::always_inline]] __m512i digit(std::size_t d) const {
        return d == 0 ? low_[0] : _mm512_add_epi64(low_[d], high_[d - 1]);
    }

private:
    __m512i low_[Digits];
    __m512i high_[Digits];
};

template <std::size_t Digits>
void fold_block(const Rows& numbers, std::size_t count, const Block& block, std::uint64_t* results) {
    const __m512i digit_mask = _mm512_set1_epi64(mask);
    for (std::size_t i = 0; i < count; i += lanes) {
        Sums<Digits> sums;
        const std::int64_t* coefficient = block.coefficients;
        for (std::size_t j = 0; j <= block.degree; ++j, coefficient += block.step) {
            sums.add({numbers.digits + i + j, numbers.stride}, _mm512_set1_epi64(*coefficient),
                     static_cast<__mmask8>(*coefficient >> 63));
        }
        __m512i carry = _mm512_setzero_si512();
#pragma GCC unroll 16
        for (std::size_t d = 0; d < Digits; ++d) {
            const __m512i sum = _mm512_add_epi64(sums.digit(d), carry);
            carry = _mm512_srai_epi64(sum, digit_bits);
            _mm512_storeu_si512(results + d * most_stride + i, _mm512_and_si512(sum, digit_mask));
        }
    }
}

std::int64_t sum_of_lanes(__m512i terms) {
    terms = _mm512_add_epi64(terms, _mm512_shuffle_i64x2(terms, terms, 0x4e));
    terms = _mm512_add_epi64(terms, _mm512_shuffle_i64x2(terms, terms, 0xb1));
    terms = _mm512_add_epi64(terms, _mm512_unpackhi_epi64(terms, terms));
    return _mm_cvtsi128_si64(_mm512_extracti32x4_epi32(terms, 0));
}

/// The one sum that is left with the last block, all its terms at a time.
template <std::size_t Digits>
void fold_to_one(const Rows& numbers, const Block& block, std::int64_t* sum) {
    const auto step = static_cast<long long>(block.step);
    const __m512i places = _mm512_set_epi64(7 * step, 6 * step, 5 * step, 4 * step, 3 * step, 2 * step, step, 0);
    const auto used = static_cast<__mmask8>((1U << (block.degree + 1)) - 1);
    const __m512i coefficients =
        _mm512_mask_i64gather_epi64(_mm512_setzero_si512(), used, places, block.coefficients, 8);
    Sums<Digits> sums;
    sums.add(numbers, coefficients, _mm512_cmplt_epi64_mask(coefficients, _mm512_setzero_si512()));
#pragma GCC unroll 16
    for (std::size_t d = 0; d < Digits; ++d) sum[d] = sum_of_lanes(sums.digit(d));
}

struct Steps {
    void (*fold)(const Rows&, std::size_t, const Block&, std::uint64_t*);
    void (*fold_to_one)(const Rows&, const Block&, std::int64_t*);
};
template <std::size_t Digits>
constexpr Steps steps_of{fold_block<Digits>, fold_to_one<Digits>};
constexpr Steps steps[] = {
    steps_of<1>,  steps_of<2>,  steps_of<3>,  steps_of<4>,  steps_of<5>,  steps_of<6>,
    steps_of<7>,  steps_of<8>,  steps_of<9>,  steps_of<10>, steps_of<11>, steps_of<12>,
    steps_of<13>, steps_of<14>, steps_of<15>, steps_of<16>,
};
static_assert(sizeof(steps) / sizeof(Steps) == most_digits);

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

void avx512_fold(const Columns& numbers, const Block* blocks, std::size_t block_count, std::int64_t* sum) {
    // What is read behind the last number of a row is not used.
    alignas(64) std::uint64_t rows[2][most_digits * most_stride];
    Rows from{numbers.digits_of_all, numbers.stride};
    std::size_t count = numbers.count;
    for (std::size_t b = 0;; ++b) {
        const Block& block = blocks[b];
        const Steps& step = steps[block.digits - 1];
        if (b + 1 == block_count && count <= lanes) return step.fold_to_one(from, block, sum);
        count -= block.degree;
        std::uint64_t* const results = rows[b % 2];
        step.fold(from, count, block, results);
        from = {results, most_stride};
        if (b + 1 == block_count) break;
        extend(results, count, block.digits, blocks[b + 1].digits);
    }
    for (std::size_t d = 0; d < blocks[block_count - 1].digits; ++d)
        sum[d] = static_cast<std::int64_t>(from.digits[d * from.stride]);
}

}  // namespace blossom::digit_folds

// NOLINTEND(portability-simd-intrinsics)
