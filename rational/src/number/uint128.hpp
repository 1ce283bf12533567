#pragma once

// Numbers of one and two machine words.

#include <bit>
#include <cstdint>
#include <utility>

namespace blossom {

__extension__ using UInt128 = unsigned __int128;
__extension__ using Int128 = __int128;

inline std::uint64_t magnitude(std::int64_t value) {
    const auto bits = static_cast<std::uint64_t>(value);
    return value < 0 ? 0 - bits : bits;
}

inline UInt128 magnitude(Int128 value) {
    const auto bits = static_cast<UInt128>(value);
    return value < 0 ? 0 - bits : bits;
}

/// 1/x modulo 2^64 for an odd x; each step of Newton's method doubles the number of correct digits.
constexpr std::uint64_t inverse_of_odd(std::uint64_t x) {
    std::uint64_t inverse = 3 * x ^ 2;
    for (int digits = 5; digits < 64; digits *= 2) inverse *= 2 - x * inverse;
    return inverse;
}

/// The greatest common divisor of a and an odd b > 0, by Stein's algorithm: one subtraction, one shift and no
/// branch except the loop's for about two binary digits.
inline std::uint64_t gcd_with_odd(std::uint64_t a, std::uint64_t b) {
    if (a == 0) return b;
    a >>= std::countr_zero(a);
    while (a != b) {
        const std::uint64_t difference = a - b;
        const std::uint64_t distance = a > b ? difference : 0 - difference;
        b = a > b ? b : a;
        a = distance >> std::countr_zero(difference);
    }
    return b;
}

/// The greatest common divisor of a and b > 0.
inline std::uint64_t gcd_of_words(std::uint64_t a, std::uint64_t b) {
    const int twos = std::countr_zero(b);
    const int shared = a == 0 ? twos : std::min(twos, std::countr_zero(a));
    return gcd_with_odd(a, b >> twos) << shared;
}

}  // namespace blossom
