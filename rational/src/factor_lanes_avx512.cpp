// Compiled for AVX-512 IFMA; run only where the processor has it.

// NOLINTBEGIN(portability-simd-intrinsics): elsewhere factors are multiplied in words
#include <immintrin.h>

#include "factor_lanes.hpp"

namespace blossom::factor_lanes {

namespace {

constexpr std::size_t number_bits = 52;
/// Of one pair of numbers.
constexpr std::size_t pair_words = 8;

/// All arithmetic is modulo 2^52 in the lower bits of the lanes.
__m512i product_of(__m512i a, __m512i b) { return _mm512_madd52lo_epu64(_mm512_setzero_si512(), a, b); }
__m512i extended(__m512i number) {
    return _mm512_srai_epi64(_mm512_slli_epi64(number, 64 - number_bits), 64 - number_bits);
}

/// The next factor of each block.
struct Factors {
    __m512i constants;
    __m512i slopes;
    __m512i denominators;
};

constexpr int lower = 0x44;   // the first and second 128 bits of both operands
constexpr int third = 0xaa;   // the third ones
constexpr int first = 0x88;   // the first and third ones
constexpr int second = 0xdd;  // the second and fourth ones

/// From the lanes of slopes, denominators and masses.
Factors factors_of(__m512i slopes, __m512i denominators, __m512i masses) {
    const __m512i all_or_nothing = _mm512_sub_epi64(_mm512_setzero_si512(), masses);
    return {_mm512_and_si512(denominators, all_or_nothing), slopes, denominators};
}

/// |m v| + |u|
__m512i size_of(const Factors& factors) {
    return _mm512_add_epi64(factors.constants, _mm512_abs_epi64(factors.slopes));
}

/// `line(b)` points to the pair of block b. Lanes beyond the blocks hold anything.
template <std::size_t Blocks, class Line>
[[gnu::always_inline]] inline Factors read(const Line& line) {
    // The even words of two pairs: numerators and denominators of u, then of m, each 128 bits.
    __m512i twos[Blocks / 2];
#pragma GCC unroll 4
    for (std::size_t i = 0; i < Blocks / 2; ++i) {
        twos[i] = _mm512_unpacklo_epi64(_mm512_loadu_si512(line(2 * i)), _mm512_loadu_si512(line(2 * i + 1)));
    }
    if constexpr (Blocks == 2) {
        return factors_of(twos[0], _mm512_shuffle_i64x2(twos[0], twos[0], 1),
                          _mm512_shuffle_i64x2(twos[0], twos[0], 2));
    } else {
        constexpr std::size_t last = Blocks / 2 - 2;
        const __m512i front = _mm512_shuffle_i64x2(twos[0], twos[1], lower);
        const __m512i back = _mm512_shuffle_i64x2(twos[last], twos[last + 1], lower);
        const __m512i masses = _mm512_shuffle_i64x2(_mm512_shuffle_i64x2(twos[0], twos[1], third),
                                                    _mm512_shuffle_i64x2(twos[last], twos[last + 1], third),
                                                    first);
        return factors_of(_mm512_shuffle_i64x2(front, back, first), _mm512_shuffle_i64x2(front, back, second),
                          masses);
    }
}

/// Degree factors a block, of which the last ones may be missing.
template <std::size_t Blocks, std::size_t Degree>
void multiply(const std::uint64_t* pairs, std::size_t count, Product& product) {
    // What is missing is 1: u = 0 and m = 1.
    alignas(64) static constexpr std::uint64_t one[pair_words] = {0, 0, 1, 0, 1, 0, 1, 0};
    Factors factors = read<Blocks>([&](std::size_t b) { return pairs + pair_words * b; });
    __m512i coefficients[Degree + 1];
    coefficients[0] = factors.constants;
    coefficients[1] = factors.slopes;
    __m512i denominators = factors.denominators;
    __m512i bounds = size_of(factors);
#pragma GCC unroll 8
    for (std::size_t i = 1; i < Degree; ++i) {
        factors = read<Blocks>([&](std::size_t b) {
            const std::size_t place = i * Blocks + b;
            return i + 1 < Degree || place < count ? pairs + pair_words * place : one;
        });
        denominators = product_of(denominators, factors.denominators);
        bounds = product_of(bounds, size_of(factors));
        coefficients[i + 1] = product_of(coefficients[i], factors.slopes);
#pragma GCC unroll 8
        for (std::size_t k = i; k > 0; --k) {
            // Two products that do not wait for each other.
            coefficients[k] = _mm512_add_epi64(product_of(coefficients[k - 1], factors.slopes),
                                               product_of(coefficients[k], factors.constants));
        }
        coefficients[0] = product_of(coefficients[0], factors.constants);
    }
#pragma GCC unroll 8
    for (std::size_t k = 0; k <= Degree; ++k)
        _mm512_store_si512(product.coefficients[k], extended(coefficients[k]));
    _mm512_store_si512(product.denominators, denominators);
    _mm512_store_si512(product.bounds, bounds);
}

using MultiplyBlocks = void (*)(const std::uint64_t*, std::size_t, Product&);
constexpr std::size_t least_degree = 2;
template <std::size_t Blocks>
constexpr MultiplyBlocks multiply_blocks[] = {multiply<Blocks, 2>, multiply<Blocks, 3>, multiply<Blocks, 4>,
                                              multiply<Blocks, 5>, multiply<Blocks, 6>, multiply<Blocks, 7>};
static_assert(least_degree + sizeof(multiply_blocks<2>) / sizeof(MultiplyBlocks) == most_degree + 1);

/// Factors of so many bits a block, so that products are below 2^51; 0 if there would be too few.
constexpr std::size_t degree_of_blocks(std::size_t bits) {
    const std::size_t degree = bits == 0 ? most_degree : (number_bits - 1) / bits;
    return degree < least_degree ? 0 : degree < most_degree ? degree : most_degree;
}
struct Degrees {
    unsigned char of[65];
};
constexpr Degrees degrees = [] {
    Degrees result{};
    for (std::size_t bits = 0; bits <= 64; ++bits)
        result.of[bits] = static_cast<unsigned char>(degree_of_blocks(bits));
    return result;
}();

template <std::size_t Blocks>
void multiply_any(const std::uint64_t* pairs, std::size_t count, Product& product) {
    product.blocks = Blocks;
    multiply_blocks<Blocks>[(count + Blocks - 1) / Blocks - least_degree](pairs, count, product);
}

}  // namespace

bool avx512_multiply(const void* pairs, std::size_t count, const Primes& primes, Product& product) {
    if (count < least_factors || count > most_factors) return false;
    const auto* const words = static_cast<const std::uint64_t*>(pairs);
    // The bits that are 0 if u is a quotient of words and m is 0 or 1, but for the denominator of m, which
    // then is 1.
    const __m512i surplus = _mm512_set_epi64(-1, ~1LL, -1, ~1LL, -1, 0, -1, 0);
    constexpr __mmask8 numerator_of_u = 1;
    __m512i all = _mm512_setzero_si512();
    std::uint32_t set = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const __m512i pair = _mm512_loadu_si512(words + pair_words * i);
        all = _mm512_or_si512(all, _mm512_mask_abs_epi64(pair, numerator_of_u, pair));
        set |= primes.of[words[pair_words * i + 2] & primes.greatest_known];
    }
    if (_mm512_test_epi64_mask(all, surplus) != 0) return false;
    const auto tops = static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm512_extracti32x4_epi32(all, 0)));
    const auto bottoms = static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm512_extracti32x4_epi32(all, 1)));
    // Bounds for each numerator and each denominator.
    if (((tops | bottoms) >> number_bits) != 0) return false;
    const std::uint64_t size = tops + bottoms;  // of each factor at the most
    product.primes = bottoms <= primes.greatest_known ? set : ~std::uint32_t{0};
    const std::size_t degree = degrees.of[64 - __builtin_clzll(size)];
    if (count <= 2 * degree) {
        multiply_any<2>(words, count, product);
    } else if (count <= 4 * degree) {
        multiply_any<4>(words, count, product);
    } else if (count <= 8 * degree) {
        multiply_any<8>(words, count, product);
    } else {
        return false;
    }
    return true;
}

}  // namespace blossom::factor_lanes

// NOLINTEND(portability-simd-intrinsics)
