#pragma once

#include <blossom/rational/rational.hpp>

#include <string>

namespace blossom {

/// The exact value m * 2^e of a double. Errors: `not_a_number` for NaN and infinities.
Rational exact_rational(double value);

/// The double nearest to `value`; ties go to the even significand, and the result may be subnormal (IEEE 754
/// binary64).
/// A number too small for any double but 0 becomes the zero of its sign.
/// Errors: `overflow` if the nearest double would be infinite: |value| >= 2^1024 - 2^970.
double nearest_double(const Rational& value);

/// The distance between neighbouring doubles at `value`: 2^(e - 52) where 2^e <= |value| < 2^(e+1), and
/// 2^-1074 below 2^-1022. Cost: one comparison of integers as long as `value`. Errors: `overflow` for |value|
/// >= 2^1024.
Rational unit_in_last_place(const Rational& value);

/// `nearest_double` as a hexadecimal floating-point literal of C, for instance "-0x1.8p+1"; zero is "0x0p+0",
/// and a negative number that is rounded to zero is "-0x0p+0".
/// Errors: as for `nearest_double`.
std::string hexadecimal_float(const Rational& value);

}  // namespace blossom
