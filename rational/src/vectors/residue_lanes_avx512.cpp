// Compiled for AVX-512 IFMA; runs only on processors that have it.

// NOLINTBEGIN(portability-simd-intrinsics): the portable version is in a file of its own
#include <immintrin.h>

#include "residue_operations.hpp"

namespace blossom::residues {

namespace {

/// Primes below 2^50, radix 2^52.
struct Ifma {
    static constexpr std::size_t prime_bits = 50;
    static constexpr std::size_t radix_bits = 52;
    static constexpr std::size_t delta_bits = 34;
    static constexpr std::size_t root_order = 13;
    static constexpr std::size_t parts = 1;
    static constexpr std::size_t most_summed = most_terms;
    static constexpr std::size_t coefficients_at_once = 4;
    static constexpr std::size_t values_at_once = 6;

    using Vector = __m512i;
    /// The lower and the upper 52 bits of the products, summed separately: sums of 4096 terms fit in 64 bits.
    struct Sum {
        __m512i low = _mm512_setzero_si512();
        __m512i high = _mm512_setzero_si512();
    };
    using Total = Sum;
    struct Constants {
        Constants(const Moduli& moduli, std::size_t part)
            : prime(load(moduli.prime, part)),
              twice(_mm512_slli_epi64(prime, 1)),
              delta(load(moduli.delta, part)),
              inverse(load(moduli.inverse, part)) {}
        __m512i prime, twice, delta, inverse;
    };

    // The load is unaligned because GCC 12 places some temporaries of functions compiled for fewer
    // instructions at multiples of 32 bytes only.
    static __m512i load(const ResidueVector& from, std::size_t /*part*/) { return _mm512_loadu_si512(&from); }
    static void store(ResidueVector& to, std::size_t /*part*/, __m512i value) {
        _mm512_storeu_si512(&to, value);
    }
    static __m512i broadcast(std::uint64_t value) { return _mm512_set1_epi64(static_cast<long long>(value)); }

    static void add_product(Sum& sum, __m512i a, __m512i b) {
        sum.low = _mm512_madd52lo_epu64(sum.low, a, b);
        sum.high = _mm512_madd52hi_epu64(sum.high, a, b);
    }
    static void collect(Total& total, const Sum& sum) {
        total.low = _mm512_add_epi64(total.low, sum.low);
        total.high = _mm512_add_epi64(total.high, sum.high);
    }
    static __m512i reduced(const Constants& constants, const Sum& sum) {
        const __m512i quotient = divided(constants, sum);
        return _mm512_madd52lo_epu64(_mm512_and_si512(quotient, broadcast((std::uint64_t{1} << 50) - 1)),
                                     _mm512_srli_epi64(quotient, 50), constants.delta);
    }
    /// A single product below 4 p^2 gives a result below 2 p without correction, and its lower half has no
    /// bits beyond 52.
    static __m512i product(const Constants& constants, __m512i a, __m512i b) {
        const __m512i zero = _mm512_setzero_si512();
        const __m512i low = _mm512_madd52lo_epu64(zero, a, b);
        const __m512i upper = _mm512_madd52hi_epu64(constants.prime, a, b);
        const __m512i multiple = _mm512_madd52lo_epu64(zero, low, constants.inverse);
        return _mm512_sub_epi64(upper, _mm512_madd52hi_epu64(zero, multiple, constants.prime));
    }
    static __m512i product_of_difference(const Constants& constants, __m512i a, __m512i b, __m512i c) {
        return product(constants, _mm512_sub_epi64(_mm512_add_epi64(a, constants.twice), b), c);
    }
    static __m512i below_prime(const Constants& constants, __m512i value) {
        return _mm512_min_epu64(value, _mm512_sub_epi64(value, constants.prime));
    }
    static __m512i sum(const Constants& constants, __m512i a, __m512i b) {
        return below_twice(constants, _mm512_add_epi64(a, b));
    }
    static __m512i difference(const Constants& constants, __m512i a, __m512i b) {
        return below_twice(constants, _mm512_add_epi64(_mm512_sub_epi64(a, b), constants.twice));
    }
    /// Values stay below 4 p, and x below 2 p. The upper half of the product is below 2 p; the multiple of
    /// the prime is subtracted from the sum of this half and a coefficient above p.
    static __m512i horner_step(const Constants& constants, __m512i value, __m512i x, __m512i coefficient) {
        const __m512i zero = _mm512_setzero_si512();
        const __m512i low = _mm512_madd52lo_epu64(zero, value, x);
        const __m512i high = _mm512_madd52hi_epu64(coefficient, value, x);
        const __m512i multiple = _mm512_madd52lo_epu64(zero, low, constants.inverse);
        return _mm512_sub_epi64(high, _mm512_madd52hi_epu64(zero, multiple, constants.prime));
    }

private:
    static __m512i below_twice(const Constants& constants, __m512i value) {
        return _mm512_min_epu64(value, _mm512_sub_epi64(value, constants.twice));
    }
    /// (sum - m p) / 2^52 + p with the multiple m that makes the lowest 52 bits zero: they cancel, and only
    /// upper halves remain. `madd52` reads 52 bits of its factors, so the bits of the lower sum beyond them
    /// are added to the upper sum.
    static __m512i divided(const Constants& constants, const Sum& sum) {
        const __m512i zero = _mm512_setzero_si512();
        const __m512i multiple = _mm512_madd52lo_epu64(zero, sum.low, constants.inverse);
        const __m512i subtracted = _mm512_madd52hi_epu64(zero, multiple, constants.prime);
        const __m512i upper = _mm512_add_epi64(sum.high, _mm512_srli_epi64(sum.low, 52));
        return _mm512_add_epi64(upper, _mm512_sub_epi64(constants.prime, subtracted));
    }
};

}  // namespace

const Operations avx512_operations = OperationsOf<Ifma>::table;

}  // namespace blossom::residues

// NOLINTEND(portability-simd-intrinsics)
