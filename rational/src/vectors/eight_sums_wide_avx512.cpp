// Sums of up to 103 bits for eight tuples at once. Compiled for AVX-512 with 52-bit and 64-bit products and
// counts of leading zeros; runs only on processors that have them.

// NOLINTBEGIN(portability-simd-intrinsics): without these instructions, one sum is computed after the other
#include "load_eight_factors.hpp"

namespace blossom::eight_sums {

namespace {

constexpr int limb_bits = 52;
constexpr std::uint64_t limb_mask = (std::uint64_t{1} << limb_bits) - 1;

/// Numbers modulo 2^104 in two limbs of 52 bits; bits of the upper limb beyond 52 are arbitrary.
struct LimbPair {
    __m512i low;
    __m512i high;
};

__m512i limb_of(__m512i word) { return _mm512_and_si512(word, broadcast(limb_mask)); }

__m512i limb_product(__m512i a, __m512i b) { return _mm512_madd52lo_epu64(_mm512_setzero_si512(), a, b); }

/// The number whose lowest limb this is, if its magnitude is less than 2^51.
__m512i signed_limb(__m512i word) {
    return _mm512_srai_epi64(_mm512_slli_epi64(word, 64 - limb_bits), 64 - limb_bits);
}

/// The limbs of a signed word.
LimbPair from_word(__m512i word) { return {limb_of(word), _mm512_srai_epi64(word, limb_bits)}; }

/// sum + a b without the carries from the lower limb.
LimbPair add_product(LimbPair sum, LimbPair a, LimbPair b) {
    sum.low = _mm512_madd52lo_epu64(sum.low, a.low, b.low);
    sum.high = _mm512_madd52hi_epu64(sum.high, a.low, b.low);
    sum.high = _mm512_madd52lo_epu64(sum.high, a.high, b.low);
    sum.high = _mm512_madd52lo_epu64(sum.high, a.low, b.high);
    return sum;
}

/// Moves the carry of the lower limb up, for a sum of at most 4096 products.
LimbPair carried(LimbPair number) {
    return {limb_of(number.low), _mm512_add_epi64(number.high, _mm512_srli_epi64(number.low, limb_bits))};
}

LimbPair zero() { return {_mm512_setzero_si512(), _mm512_setzero_si512()}; }

LimbPair product(LimbPair a, LimbPair b) { return add_product(zero(), a, b); }

/// Divides by 2^count < 2^52; both limbs are below 2^52.
LimbPair shifted(LimbPair number, __m512i count) {
    const __m512i rest = _mm512_sub_epi64(broadcast(limb_bits), count);
    return {
        limb_of(_mm512_or_si512(_mm512_srlv_epi64(number.low, count), _mm512_sllv_epi64(number.high, rest))),
        _mm512_srlv_epi64(number.high, count)};
}

/// Divides two numbers, not both 0, by their common power of two.
void divide_by_common_twos(LimbPair& a, LimbPair& b) {
    const __mmask8 no_low = _mm512_testn_epi64_mask(_mm512_or_si512(a.low, b.low), broadcast(limb_mask));
    LimbPair* const numbers[] = {&a, &b};
    for (LimbPair* number : numbers) {
        number->low = _mm512_mask_mov_epi64(number->low, no_low, number->high);
        number->high = _mm512_mask_mov_epi64(number->high, no_low, _mm512_setzero_si512());
    }
    const __m512i twos = trailing_zeros(_mm512_or_si512(a.low, b.low));
    a = shifted(a, twos);
    b = shifted(b, twos);
}

/// Divides two numbers below 2^103 by their common odd prime divisors, all of which are in `set`: once by all
/// of them, with the product of their inverses, and again by those that were found.
void divide_by_common_primes(const WideDivisor* divisors, std::uint32_t set, LimbPair& top,
                             LimbPair& bottom) {
    const LimbPair one{broadcast(1), _mm512_setzero_si512()};
    while (set != 0) {
        LimbPair inverses = one;
        std::uint32_t found = 0;
        for (std::uint32_t rest = set; rest != 0; rest &= rest - 1) {
            const WideDivisor& divisor = divisors[__builtin_ctz(rest)];
            const LimbPair inverse{broadcast(divisor.inverse[0]), broadcast(divisor.inverse[1])};
            const __m512i beyond = broadcast(divisor.beyond);
            const __mmask8 divides = _mm512_mask_cmplt_epu64_mask(
                _mm512_cmplt_epu64_mask(limb_of(product(bottom, inverse).high), beyond),
                limb_of(product(top, inverse).high), beyond);
            if (divides != 0) {
                inverses = product(inverses, {_mm512_mask_mov_epi64(one.low, divides, inverse.low),
                                              _mm512_mask_mov_epi64(one.high, divides, inverse.high)});
                found |= rest & -rest;
            }
        }
        if (found == 0) return;
        top = product(top, inverses);
        bottom = product(bottom, inverses);
        set = found;
    }
}

void store(LimbPair number, std::uint64_t (&words)[2][lanes]) {
    const __m512i high = limb_of(number.high);
    _mm512_storeu_si512(words[0], _mm512_or_si512(number.low, _mm512_slli_epi64(high, limb_bits)));
    _mm512_storeu_si512(words[1], _mm512_srli_epi64(high, 64 - limb_bits));
}

/// The bit widths of numbers > 0.
__m512i bit_width(__m512i words) { return _mm512_sub_epi64(broadcast(64), _mm512_lzcnt_epi64(words)); }

/// The product of the factors of eight tuples, and the product of their denominators.
struct Product {
    LimbPair coefficients[most_wide_factors + 1];
    LimbPair denominator;

    /// Returns false and does nothing unless the sums provably have less than 103 bits.
    template <class Reader>
    bool read(const Rows& rows, Reader reader, std::size_t count, const Divisors& divisors,
              std::uint32_t& set) {
        Factor factors[most_wide_factors];
        __m512i beyond = _mm512_setzero_si512();
        __m512i bits = broadcast(rows.bits);
        __m512i denominator_bits = bits;
        const __m512i most_of_limb = broadcast(rows.bits + limb_bits - 1);
        std::size_t in_one_limb = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const Factor factor = reader.read(i);
            const __m512i size = l1_norm(factor);
            beyond = _mm512_or_si512(beyond, _mm512_srli_epi64(size, 63));
            beyond = _mm512_or_si512(
                beyond, _mm512_andnot_si512(broadcast(divisors.greatest_known), factor.denominator));
            bits = _mm512_add_epi64(bits, bit_width(size));
            denominator_bits = _mm512_add_epi64(denominator_bits, bit_width(factor.denominator));
            if (in_one_limb == i && _mm512_cmpgt_epu64_mask(bits, most_of_limb) == 0) in_one_limb = i + 1;
            factors[i] = factor;
        }
        const __m512i most = _mm512_max_epu64(bits, denominator_bits);
        if (_mm512_test_epi64_mask(_mm512_or_si512(beyond, reader.beyond()), broadcast(~std::uint64_t{0})) !=
                0 ||
            _mm512_cmpgt_epu64_mask(most, broadcast(2 * limb_bits - 2)) != 0)
            return false;
        PrimeSets sets(divisors);
        for (std::size_t i = 0; i < count; ++i) sets.add(factors[i].denominator);
        set = rows.divisors | sets.all();
        if (set == ~std::uint32_t{0}) return false;
        multiply_out(rows, factors, count, in_one_limb);
        return true;
    }

private:
    /// The product of the first `in_one_limb` factors has coefficients below 2^51.
    void multiply_out(const Rows& rows, const Factor* factors, std::size_t count, std::size_t in_one_limb) {
        __m512i limbs[most_wide_factors + 1];
        limbs[0] = broadcast(1);
        for (std::size_t i = 0; i < in_one_limb; ++i) {
            const auto& [constant, slope, bottom] = factors[i];
            limbs[i + 1] = _mm512_setzero_si512();
            for (std::size_t k = i + 1; k > 0; --k) {
                limbs[k] = _mm512_madd52lo_epu64(limb_product(limbs[k], constant), limbs[k - 1], slope);
            }
            limbs[0] = limb_product(limbs[0], constant);
        }
        for (std::size_t k = 0; k <= in_one_limb; ++k) coefficients[k] = from_word(signed_limb(limbs[k]));
        denominator = from_word(broadcast(rows.denominator));
        for (std::size_t i = 0; i < count; ++i)
            denominator = product(denominator, from_word(factors[i].denominator));
        for (std::size_t i = in_one_limb; i < count; ++i) {
            const LimbPair constant = from_word(factors[i].constant);
            const LimbPair slope = from_word(factors[i].slope);
            coefficients[i + 1] = zero();
            for (std::size_t k = i + 1; k > 0; --k) {
                coefficients[k] =
                    carried(add_product(product(coefficients[k], constant), coefficients[k - 1], slope));
            }
            coefficients[0] = product(coefficients[0], constant);
        }
    }
};

template <class Reader>
bool sums_from(const Rows& rows, const Reader& reader, std::size_t count, const Divisors& divisors,
               WideQuotients* quotients) {
    Product factors;  // NOLINT(cppcoreguidelines-pro-type-member-init): `read` sets what is read
    std::uint32_t set = 0;
    if (!factors.read(rows, reader, count, divisors, set)) return false;
    const std::int64_t* row = rows.numbers;
    for (std::size_t j = 0; j < rows.rows; ++j, row += count + 1) {
        LimbPair sum = zero();
        for (std::size_t k = 0; k <= count; ++k)
            sum = add_product(sum, factors.coefficients[k], from_word(_mm512_set1_epi64(row[k])));
        sum = carried(sum);
        const __mmask8 negative =
            _mm512_test_epi64_mask(sum.high, broadcast(std::uint64_t{1} << (limb_bits - 1)));
        const LimbPair negated = carried(product(sum, from_word(broadcast(~std::uint64_t{0}))));
        LimbPair top{_mm512_mask_mov_epi64(sum.low, negative, negated.low),
                     limb_of(_mm512_mask_mov_epi64(sum.high, negative, negated.high))};
        LimbPair bottom{factors.denominator.low, limb_of(factors.denominator.high)};
        divide_by_common_twos(top, bottom);
        divide_by_common_primes(divisors.wide, set, top, bottom);
        store(top, quotients[j].numerators);
        store(bottom, quotients[j].denominators);
        quotients[j].negative = static_cast<std::uint8_t>(negative);
    }
    return true;
}

bool sums(const Rows& rows, const void* const* tuples, std::size_t count, const WordLine* line,
          const Divisors& divisors, WideQuotients* quotients) {
    return line == nullptr ? sums_from(rows, PairReader(tuples), count, divisors, quotients)
                           : sums_from(rows, LineReader(tuples, *line), count, divisors, quotients);
}

}  // namespace

const WideOperations wide_avx512_operations{sums};

}  // namespace blossom::eight_sums

// NOLINTEND(portability-simd-intrinsics)
