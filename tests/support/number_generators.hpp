#pragma once

#include <blossom/rational/rational.hpp>

#include <cstddef>
#include <cstdint>

#include "random.hpp"

namespace blossom::testing {

/// The families of integers that `integer` produces, with their frequencies out of 16.
enum class IntegerKind {
    unit,      ///< 3: 0, 1 or -1
    tiny,      ///< 4: |x| <= 100
    word,      ///< 3: any value of 64 bits
    boundary,  ///< 4: +-2^e + d for e in `boundary_exponents` and |d| <= 2
    huge,      ///< 2: 65 to 700 bits
};

inline constexpr std::size_t boundary_exponents[] = {31, 63, 64, 128};

Integer integer(Random& random);
Integer integer(Random& random, IntegerKind kind);
/// An integer of exactly `bits` binary digits, of either sign.
Integer integer_of_bits(Random& random, std::size_t bits);

/// p / q with |p| <= 12 and 1 <= q <= 9.
Rational small_rational(Random& random);
/// Half of the numbers are small, a quarter are integers, and a quarter are quotients of two integers of any
/// kind.
Rational rational(Random& random);

}  // namespace blossom::testing
