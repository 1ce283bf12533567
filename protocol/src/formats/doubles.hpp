#pragma once

#include <blossom/rational/rational.hpp>

#include <blossom/protocol/json.hpp>

/// The conversion of doubles in the files of other programs.

namespace blossom::protocol {

/// The exact value of the double that a JSON number, or a decimal or hexadecimal-float string, is read as; a
/// number that is exact already stays.
/// Errors: `not_a_number`; `overflow` beyond the range of doubles.
Rational read_double(const Json& value);

/// The nearest double, as a JSON number with the fewest digits that are read back as the same;
/// "-0.0" for a negative number that is rounded to 0. Errors: `overflow`.
Json::Number double_number(const Rational& value);

}  // namespace blossom::protocol
