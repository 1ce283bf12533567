// Compiled for AVX-512 IFMA; runs only on processors that have it.

// NOLINTBEGIN(portability-simd-intrinsics): without these instructions, rows of limbs are used
#include <immintrin.h>

#include "fold_blocks.hpp"

namespace blossom::fold_blocks {

namespace {

constexpr std::size_t lanes = 8;
constexpr std::uint64_t mask = (std::uint64_t{1} << digit_bits) - 1;

__m512i load(const std::uint64_t* from) { return _mm512_loadu_si512(from); }

/// All ones where the top digit of a number is negative.
__m512i extension(__m512i top) {
    const __m512i sign = _mm512_srai_epi64(_mm512_slli_epi64(top, 64 - digit_bits), 63);
    return _mm512_and_si512(sign, _mm512_set1_epi64(mask));
}

/// Numbers in digits; `stride` is the distance between digits of consecutive positions.
struct Rows {
    const std::uint64_t* digits;
    std::size_t stride;
};

/// Eight sums of products at once, modulo 2^52 to the power of the digits. A coefficient is taken modulo
/// 2^52; a negative one is then 2^52 too large, which is subtracted one digit higher. Each term adds less
/// than 2^52 to one of the 64-bit sums.
template <std::size_t Digits>
class Sums {
public:
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): the elements are set one by one
    [[gnu::always_inline]] Sums() {
#pragma GCC unroll 16
        for (std::size_t d = 0; d < Digits; ++d) low_[d] = high_[d] = _mm512_setzero_si512();
    }
    [[gnu::always_inline]] void add(const Rows& numbers, __m512i coefficients) {
        const __mmask8 negative = _mm512_cmplt_epi64_mask(coefficients, _mm512_setzero_si512());
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
    [[gnu::always_inline]] void add(const Sums& other) {
#pragma GCC unroll 16
        for (std::size_t d = 0; d < Digits; ++d) {
            low_[d] = _mm512_add_epi64(low_[d], other.low_[d]);
            high_[d] = _mm512_add_epi64(high_[d], other.high_[d]);
        }
    }
    /// The digit d, whose carry has not been propagated.
    [[gnu::always_inline]] __m512i digit(std::size_t d) const {
        return d == 0 ? low_[0] : _mm512_add_epi64(low_[d], high_[d - 1]);
    }

private:
    __m512i low_[Digits];
    __m512i high_[Digits];
};

/// Up to this many digits, the registers suffice for two independent sums.
constexpr std::size_t most_digits_of_two = 6;

/// The results have one digit more than the sums, which repeats the sign: blocks add at most one digit.
template <std::size_t Digits>
void fold_block(const Rows& numbers, std::size_t count, const Block& block, std::uint64_t* results) {
    const __m512i digit_mask = _mm512_set1_epi64(mask);
    for (std::size_t i = 0; i < count; i += lanes) {
        Sums<Digits> sums;
        const std::int64_t* const coefficients = block.coefficients;
        const auto add = [&](Sums<Digits>& to, std::size_t j) {
            to.add({numbers.digits + i + j, numbers.stride}, _mm512_set1_epi64(coefficients[j * block.step]));
        };
        std::size_t j = 0;
        if constexpr (Digits <= most_digits_of_two) {
            Sums<Digits> others;
            for (; j < block.degree; j += 2) {
                add(sums, j);
                add(others, j + 1);
            }
            sums.add(others);
        }
        for (; j <= block.degree; ++j) add(sums, j);
        __m512i carry = _mm512_setzero_si512();
        __m512i digit = carry;
#pragma GCC unroll 16
        for (std::size_t d = 0; d < Digits; ++d) {
            const __m512i sum = _mm512_add_epi64(sums.digit(d), carry);
            carry = _mm512_srai_epi64(sum, digit_bits);
            digit = _mm512_and_si512(sum, digit_mask);
            _mm512_storeu_si512(results + d * most_stride + i, digit);
        }
        _mm512_storeu_si512(results + Digits * most_stride + i, extension(digit));
    }
}

/// Writes the sums of the lanes of four vectors to sums[0..3].
void store_sums_of_lanes(const __m512i* digits, std::int64_t* sums) {
    const __m512i first = _mm512_add_epi64(_mm512_unpacklo_epi64(digits[0], digits[1]),
                                           _mm512_unpackhi_epi64(digits[0], digits[1]));
    const __m512i second = _mm512_add_epi64(_mm512_unpacklo_epi64(digits[2], digits[3]),
                                            _mm512_unpackhi_epi64(digits[2], digits[3]));
    constexpr int even = 0x88;  // the first and third 128 bits of both operands
    constexpr int odd = 0xdd;
    __m512i halves =
        _mm512_add_epi64(_mm512_shuffle_i64x2(first, second, even), _mm512_shuffle_i64x2(first, second, odd));
    halves = _mm512_add_epi64(_mm512_shuffle_i64x2(halves, halves, even),
                              _mm512_shuffle_i64x2(halves, halves, odd));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(sums), _mm512_extracti64x4_epi64(halves, 0));
}

/// The last block leaves one sum, whose terms are computed at once.
template <std::size_t Digits>
void fold_to_one(const Rows& numbers, const Block& block, std::int64_t* sum) {
    const auto used = static_cast<__mmask8>((1U << (block.degree + 1)) - 1);
    const __m512i coefficients = _mm512_maskz_loadu_epi64(used, block.coefficients);
    Sums<Digits> sums;
    sums.add(numbers, coefficients);
    constexpr std::size_t at_a_time = 4;
#pragma GCC unroll 4
    for (std::size_t first = 0; first < Digits; first += at_a_time) {
        __m512i digits[at_a_time];
#pragma GCC unroll 4
        for (std::size_t i = 0; i < at_a_time; ++i)
            digits[i] = first + i < Digits ? sums.digit(first + i) : _mm512_setzero_si512();
        store_sums_of_lanes(digits, sum + first);
    }
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

}  // namespace

void avx512_fold(const Columns& numbers, const Block* blocks, std::size_t block_count, std::int64_t* sum) {
    // The elements beyond the last number of a row are read but not used.
    alignas(64) std::uint64_t rows[2][(most_digits + 1) * most_stride];
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
    }
    for (std::size_t d = 0; d < blocks[block_count - 1].digits; ++d)
        sum[d] = static_cast<std::int64_t>(from.digits[d * from.stride]);
}

}  // namespace blossom::fold_blocks

// NOLINTEND(portability-simd-intrinsics)
