#include "memory.hpp"

#include <sys/resource.h>

namespace blossom::testing {

std::size_t peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
    constexpr std::size_t units_a_mebibyte = std::size_t{1} << 20;
#else
    constexpr std::size_t units_a_mebibyte = std::size_t{1} << 10;
#endif
    return static_cast<std::size_t>(usage.ru_maxrss) / units_a_mebibyte;
}

}  // namespace blossom::testing
