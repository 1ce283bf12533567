#pragma once

#include <blossom/rational/limits.hpp>
#include <blossom/rational/rational.hpp>

#include <string_view>

namespace blossom {

/// The number that a text denotes: "p", "p/q" or an exact decimal such as "-0.125" or "1.5e-3". All numbers
/// in texts are read here.
///
/// A leading '-' applies to the whole number. There is no '+', no space, no sign after '/', no bare "." and
/// no other base: "010" is ten, "6/4" is 3/2, and "6/-4", "+1", "", " 1", "0x10", "1.", ".5", "1e5/2" are
/// errors.
///
/// Cost: that of converting the digits to binary.
/// Errors: `not_a_number`; `zero_denominator`; `limit_exceeded` if the value would have more than
/// `limits.digits` digits, including those that an exponent adds.
Rational parse_rational(std::string_view text, const Limits& limits = {});

/// As `parse_rational`, but only for integers without point, exponent and slash.
Integer parse_integer(std::string_view text, const Limits& limits = {});

/// The length of the unsigned decimal at the front of `text`, such as "12", "0.5" or "1.5e-3"; 0 if there is
/// none.
std::size_t unsigned_decimal_length(std::string_view text);

/// At most 40 characters of `text` for an error message, in quotation marks and with unprintable bytes
/// escaped.
std::string quoted(std::string_view text);

/// The first character of a UTF-8 text, with all its bytes.
std::string_view first_character(std::string_view text);

}  // namespace blossom
