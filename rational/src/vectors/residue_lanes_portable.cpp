#include "residue_lanes_narrow.hpp"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace blossom::residues {

namespace {

struct TwoLanes {
    typedef std::uint64_t Vector __attribute__((vector_size(16)));  // NOLINT(modernize-use-using)

    // NOLINTBEGIN(portability-simd-intrinsics): compilers do not see that products of lower halves suffice
    static Vector product(Vector a, Vector b) {
#if defined(__SSE2__)
        return reinterpret_cast<Vector>(
            _mm_mul_epu32(reinterpret_cast<__m128i>(a), reinterpret_cast<__m128i>(b)));
#else
        constexpr std::uint64_t low_half = 0xffff'ffff;
        return (a & low_half) * (b & low_half);
#endif
    }
    // NOLINTEND(portability-simd-intrinsics)
};

}  // namespace

const Operations portable_operations = OperationsOf<Narrow<TwoLanes>>::table;

}  // namespace blossom::residues
