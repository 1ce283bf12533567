// Compiled for AVX-512 IFMA; runs only on processors that have it.

// NOLINTBEGIN(portability-simd-intrinsics): without these instructions, factors are multiplied in words
#include <immintrin.h>

#include "factor_lanes.hpp"
#include "factor_products.hpp"

namespace blossom::factor_products {

namespace {

using factor_lanes::Factor;
using factor_lanes::l1_norm;
using factor_lanes::united;

constexpr std::size_t number_bits = 52;

/// All arithmetic is modulo 2^52, in the lower bits of the lanes.
__m512i add_product(__m512i sum, __m512i a, __m512i b) { return _mm512_madd52lo_epu64(sum, a, b); }
__m512i product_of(__m512i a, __m512i b) { return add_product(_mm512_setzero_si512(), a, b); }
__m512i extended(__m512i number) {
    return _mm512_srai_epi64(_mm512_slli_epi64(number, 64 - number_bits), 64 - number_bits);
}

/// Factors of three words each: constant, slope and denominator.
struct Source {
    static constexpr std::size_t words = 3;
    static constexpr std::size_t denominator = 2;  ///< its position in a factor

    const std::uint64_t* factors;

    const std::uint64_t* at(std::size_t i) const { return factors + words * i; }

    template <std::size_t Blocks, bool Complete>
    [[gnu::always_inline]] Factor read(std::size_t first, std::size_t count) const {
        const std::size_t used = Complete || first + Blocks <= count ? Blocks : count - first;
        constexpr std::size_t vectors = (words * Blocks + lanes - 1) / lanes;
        __m512i loaded[3];
#pragma GCC unroll 3
        for (std::size_t i = 0; i < 3; ++i) loaded[i] = i < vectors ? part(first, used, i) : loaded[0];
        return {every_third<vectors>(loaded, 0), every_third<vectors>(loaded, 1),
                every_third<vectors>(loaded, 2)};
    }

private:
    static constexpr std::size_t lanes = 8;

    /// Eight of the words of `used` factors; missing factors are replaced by the factor 1.
    __m512i part(std::size_t first, std::size_t used, std::size_t i) const {
        const std::size_t begin = lanes * i;
        const std::size_t end = words * used;
        const std::size_t present = end <= begin ? 0 : end - begin < lanes ? end - begin : lanes;
        // Slopes are words 1, 4, 7, 10, ...
        const auto slopes = static_cast<__mmask8>(i == 0 ? 0x92 : i == 1 ? 0x24 : 0x49);
        const __m512i ones = _mm512_mask_mov_epi64(_mm512_set1_epi64(1), slopes, _mm512_setzero_si512());
        return _mm512_mask_loadu_epi64(ones, static_cast<__mmask8>((1U << present) - 1), at(first) + begin);
    }
    /// The words `place`, place + 3, ... of the vectors, in lanes 0, 1, ...
    template <std::size_t Vectors>
    static __m512i every_third(const __m512i* loaded, long long place) {
        const __m512i places =
            _mm512_add_epi64(_mm512_set_epi64(21, 18, 15, 12, 9, 6, 3, 0), _mm512_set1_epi64(place));
        const __m512i two = _mm512_permutex2var_epi64(loaded[0], places, loaded[1]);
        if constexpr (Vectors < 3) return two;
        // The first two of the vectors hold the words below 16.
        const __mmask8 beyond = _mm512_cmpge_epi64_mask(places, _mm512_set1_epi64(16));
        return _mm512_mask_permutexvar_epi64(two, beyond, places, loaded[2]);
    }
};

/// One lane of eight vectors.
template <std::size_t Lane>
__m512i lane_of_all(const __m512i* vectors) {
    static_assert(Lane % 2 == 1);
    __m512i twos[4];
#pragma GCC unroll 4
    for (std::size_t i = 0; i < 4; ++i) twos[i] = _mm512_unpackhi_epi64(vectors[2 * i], vectors[2 * i + 1]);
    constexpr int everywhere = Lane / 2 * 0x55;
    constexpr int odd_places = 0x88;  // the first and third 128 bits of both operands
    return _mm512_shuffle_i64x2(_mm512_shuffle_i64x2(twos[0], twos[1], everywhere),
                                _mm512_shuffle_i64x2(twos[2], twos[3], everywhere), odd_places);
}

std::size_t width(std::uint64_t word) {
    return word == 0 ? 0 : 64 - static_cast<std::size_t>(__builtin_clzll(word));
}

/// The fewest factors of a block.
constexpr std::size_t least_degree = 2;
static_assert(least_factors > 4 * (least_degree - 1));

/// Whether products of this many factors are below 2^51, if each factor is below 2^bits.
constexpr bool is_enough(std::size_t factors, std::size_t bits) { return factors * bits < number_bits; }

/// The result of an attempt with one number of blocks: if the products are too large, more blocks may
/// suffice.
enum class Outcome { done, too_large, never };

/// At most `Degree` factors per block; the last ones may be missing.
template <std::size_t Blocks, std::size_t Degree>
Outcome multiply_blocks(const std::uint64_t* words, std::size_t count, const Primes& primes,
                        Product& product) {
    const Source source{words};
    const __m512i zero = _mm512_setzero_si512();
    Factor factors = source.read<Blocks, true>(0, count);
    __m512i coefficients[most_degree + 1];
    coefficients[0] = factors.constant;
    coefficients[1] = factors.slope;
    __m512i denominators = factors.denominator;
    __m512i all_denominators = denominators;
    __m512i bounds = l1_norm(factors);
    __m512i all_sizes = bounds;
#pragma GCC unroll 8
    for (std::size_t i = 1; i < Degree; ++i) {
        factors = i + 1 < Degree ? source.read<Blocks, true>(i * Blocks, count)
                                 : source.read<Blocks, false>(i * Blocks, count);
        denominators = product_of(denominators, factors.denominator);
        all_denominators = _mm512_or_si512(all_denominators, factors.denominator);
        const __m512i sizes = l1_norm(factors);
        bounds = product_of(bounds, sizes);
        all_sizes = _mm512_or_si512(all_sizes, sizes);
        coefficients[i + 1] = product_of(coefficients[i], factors.slope);
#pragma GCC unroll 8
        for (std::size_t k = i; k > 0; --k) {
            coefficients[k] = add_product(product_of(coefficients[k - 1], factors.slope), coefficients[k],
                                          factors.constant);
        }
        coefficients[0] = product_of(coefficients[0], factors.constant);
    }
    const std::uint64_t every_denominator = united<Blocks>(all_denominators);
    const std::size_t bits = width(united<Blocks>(all_sizes) | every_denominator);
    if (!is_enough(Degree, bits)) return is_enough(least_degree, bits) ? Outcome::too_large : Outcome::never;
#pragma GCC unroll 8
    for (std::size_t k = 0; k <= most_degree; ++k) {
        coefficients[k] = k <= Degree ? extended(coefficients[k]) : zero;
        if (k <= Degree) _mm512_storeu_si512(product.coefficients[k], coefficients[k]);
    }
    _mm512_storeu_si512(product.last, lane_of_all<Blocks - 1>(coefficients));
    _mm512_storeu_si512(product.bounds, bounds);
    _mm512_storeu_si512(product.denominators, denominators);
    product.blocks = Blocks;
    std::uint32_t set = 0;
    for (std::size_t i = 0; i < count; ++i)
        set |= primes.of[source.at(i)[Source::denominator] & primes.greatest_known];
    product.primes = every_denominator <= primes.greatest_known ? set : ~std::uint32_t{0};
    return Outcome::done;
}

template <std::size_t Blocks>
Outcome multiply_any(const std::uint64_t* words, std::size_t count, const Primes& primes, Product& product) {
    using Multiply = Outcome (*)(const std::uint64_t*, std::size_t, const Primes&, Product&);
    static constexpr Multiply multiply_degrees[] = {multiply_blocks<Blocks, 2>, multiply_blocks<Blocks, 3>,
                                                    multiply_blocks<Blocks, 4>, multiply_blocks<Blocks, 5>,
                                                    multiply_blocks<Blocks, 6>, multiply_blocks<Blocks, 7>};
    static_assert(least_degree + sizeof(multiply_degrees) / sizeof(Multiply) == most_degree + 1);
    const std::size_t degree = (count + Blocks - 1) / Blocks;
    if (degree < least_degree || degree > most_degree) return Outcome::too_large;
    return multiply_degrees[degree - least_degree](words, count, primes, product);
}

}  // namespace

bool avx512_multiply(const void* factors, std::size_t count, const Primes& primes, Product& product) {
    if (count < least_factors) return false;
    const auto* const words = static_cast<const std::uint64_t*>(factors);
    Outcome outcome = multiply_any<2>(words, count, primes, product);
    if (outcome == Outcome::too_large) outcome = multiply_any<4>(words, count, primes, product);
    if (outcome == Outcome::too_large) outcome = multiply_any<8>(words, count, primes, product);
    return outcome == Outcome::done;
}

}  // namespace blossom::factor_products

// NOLINTEND(portability-simd-intrinsics)
