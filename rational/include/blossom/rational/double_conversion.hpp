#pragma once

#include <blossom/rational/rational.hpp>

#include <string>

namespace blossom {

/// The rational number that a double is, exactly: m * 2^e. Errors: `not_a_number` for NaN and infinities.
Rational exact_rational(double value);

/// The double nearest to `value`, ties to the even significand, subnormal where needed (IEEE 754 binary64).
/// Errors: `overflow` when the nearest would be infinite, |value| >= 2^1024 - 2^970.
double nearest_double(const Rational& value);

/// `nearest_double` as a C hexadecimal-float string, for instance "-0x1.8p+1"; zero is "0x0p+0".
/// Errors: `overflow`, as there.
std::string hexadecimal_float(const Rational& value);

}  // namespace blossom
