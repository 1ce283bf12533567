// Compiled for AVX2; runs only on processors that have it.

#include <immintrin.h>

#include "residue_lanes_narrow.hpp"

namespace blossom::residues {

namespace {

struct FourLanes {
    typedef std::uint64_t Vector __attribute__((vector_size(32)));  // NOLINT(modernize-use-using)

    // NOLINTBEGIN(portability-simd-intrinsics): compilers do not see that products of lower halves suffice
    static Vector product(Vector a, Vector b) {
        return reinterpret_cast<Vector>(
            _mm256_mul_epu32(reinterpret_cast<__m256i>(a), reinterpret_cast<__m256i>(b)));
    }
    // NOLINTEND(portability-simd-intrinsics)
};

}  // namespace

const Operations avx2_operations = OperationsOf<Narrow<FourLanes>>::table;

}  // namespace blossom::residues
