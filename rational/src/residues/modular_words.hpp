#pragma once

// Words modulo a prime below 2^63, for the computation of tables, where speed does not matter.

#include <cstdint>

#include "number/uint128.hpp"

namespace blossom::modular {

inline std::uint64_t product(std::uint64_t a, std::uint64_t b, std::uint64_t prime) {
    return static_cast<std::uint64_t>(UInt128{a} * b % prime);
}

inline std::uint64_t power(std::uint64_t base, std::uint64_t exponent, std::uint64_t prime) {
    std::uint64_t result = 1;
    for (; exponent != 0; exponent >>= 1) {
        if (exponent & 1) result = product(result, base, prime);
        base = product(base, base, prime);
    }
    return result;
}

}  // namespace blossom::modular
