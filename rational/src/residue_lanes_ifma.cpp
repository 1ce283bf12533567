// Compiled for AVX-512 IFMA; run only where the processor has it.

// NOLINTBEGIN(portability-simd-intrinsics): the portable way is a file of its own
#include <immintrin.h>

#include "residue_operations.hpp"

namespace blossom::residues {

namespace {

struct Ifma {
    using Vector = __m512i;
    /// The lower and the upper 52 bits of the products, summed apart: sums of 4096 terms fit in 64 bits.
    struct Accumulator {
        __m512i low = _mm512_setzero_si512();
        __m512i high = _mm512_setzero_si512();
    };

    static __m512i load(const Octet& from) { return _mm512_load_si512(&from); }
    static __m512i broadcast(std::uint64_t value) { return _mm512_set1_epi64(static_cast<long long>(value)); }
    static void add_product(Accumulator& sum, __m512i a, __m512i b) {
        sum.low = _mm512_madd52lo_epu64(sum.low, a, b);
        sum.high = _mm512_madd52hi_epu64(sum.high, a, b);
    }
    static void add(Accumulator& sum, const Accumulator& other) {
        sum.low = _mm512_add_epi64(sum.low, other.low);
        sum.high = _mm512_add_epi64(sum.high, other.high);
    }
    static Octet negated(const Moduli& moduli, const Octet& residues) {
        const __m512i value = load(residues);
        Octet result{};
        _mm512_store_si512(
            &result, _mm512_maskz_sub_epi64(_mm512_test_epi64_mask(value, value), load(moduli.prime), value));
        return result;
    }
    /// `madd52` reads 52 bits of its factors: the multiple is taken of the lowest 52 alone, and what the
    /// lower sum has beyond them goes to the upper one first.
    static Octet reduced(const Moduli& moduli, const Accumulator& sum) {
        const __m512i zero = _mm512_setzero_si512();
        const __m512i prime = load(moduli.prime);
        const __m512i low_52 = broadcast((std::uint64_t{1} << 52) - 1);
        const __m512i lower = broadcast(low_50);
        const __m512i low = _mm512_and_si512(sum.low, low_52);
        const __m512i high = _mm512_add_epi64(sum.high, _mm512_srli_epi64(sum.low, 52));
        const __m512i multiple = _mm512_madd52lo_epu64(zero, low, load(moduli.negative_inverse));
        const __m512i lowest = _mm512_madd52lo_epu64(low, multiple, prime);
        const __m512i quotient =
            _mm512_add_epi64(_mm512_madd52hi_epu64(high, multiple, prime), _mm512_srli_epi64(lowest, 52));
        const __m512i folded = _mm512_madd52lo_epu64(_mm512_and_si512(quotient, lower),
                                                     _mm512_srli_epi64(quotient, 50), load(moduli.delta));
        Octet result{};
        _mm512_store_si512(&result, _mm512_min_epu64(folded, _mm512_sub_epi64(folded, prime)));
        return result;
    }
};

}  // namespace

const Operations ifma_operations = OperationsOf<Ifma>::table;

}  // namespace blossom::residues

// NOLINTEND(portability-simd-intrinsics)
