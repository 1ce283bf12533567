#pragma once

#include <blossom/rational/rational.hpp>

#include <blossom/protocol/json.hpp>

/// Doubles of other programs, in and out.

namespace blossom::protocol {

/// The exact value of the double that a JSON number, or a decimal or hexadecimal-float string, is read as.
/// Errors: `not_a_number`; `overflow` beyond the range of doubles.
Rational read_double(const Json& value);

/// The nearest double, as a JSON number with the fewest digits that are read back as the same.
/// Errors: `overflow`.
Json::Number double_number(const Rational& value);

/// The distance of the doubles around the value: 2^(e - 52) where its nearest double is at least 2^e and less
/// than 2^(e+1), and 2^-1074 below 2^-1022. Errors: `overflow`.
Rational unit_in_last_place(const Rational& value);

}  // namespace blossom::protocol
