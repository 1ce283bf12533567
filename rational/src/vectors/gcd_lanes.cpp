#include "gcd_lanes.hpp"

#include "vector_level.hpp"

namespace blossom::gcd_lanes {

Gcds chosen() {
    static const Gcds gcds = []() -> Gcds {
#if defined(BLOSSOM_AVX512_GCDS)
        if (vectors::level() == "ifma" && __builtin_cpu_supports("avx512f") &&
            __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512ifma"))
            return {avx512_word_gcds, avx512_long_gcds};
#endif
        return {};
    }();
    return gcds;
}

}  // namespace blossom::gcd_lanes
