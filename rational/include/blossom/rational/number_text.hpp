#pragma once

#include <blossom/rational/limits.hpp>
#include <blossom/rational/rational.hpp>

#include <string_view>

namespace blossom {

/// The one door from text to numbers: "p", "p/q", an exact decimal "-0.125", ".5", "0.", "1.5e-3", a
/// hexadecimal float "0x1.8p-3", which is m * 2^e exactly, a vulgar fraction "½" or "1½", and a power or a
/// decimal times one, "2^-53", "10⁻³", "1.5·10^-3".
///
/// A leading '-' belongs to the whole; marks are read as `written_mark` has them, with no space between them.
/// There is no '+', no sign after '/' and no hexadecimal number without an exponent: "010" is ten, "6/4" is
/// 3/2, and "6/-4", "+1", "", " 1", "0x10", "1e5/2" are errors.
///
/// Cost: that of converting the digits to binary.
/// Errors: `not_a_number`; `zero_denominator`; `limit_exceeded` if the value would have more than
/// `limits.digits` digits, including those that an exponent adds.
Rational parse_rational(std::string_view text, const Limits& limits = {});

/// As `parse_rational`, but only for integers without point, exponent and slash.
Integer parse_integer(std::string_view text, const Limits& limits = {});

/// How many bytes at the front of `text` form an unsigned number without a slash: a decimal "12", "0.5", ".5"
/// or "1.5e-3", "0." unless another point follows, a hexadecimal float "0x1.8p-3", a vulgar fraction "½" or
/// "1½"; 0 when none do.
std::size_t unsigned_number_length(std::string_view text);

/// At most 40 characters of `text` for an error message, in quotation marks and with unprintable bytes
/// escaped.
std::string quoted(std::string_view text);

/// The first character of a UTF-8 text, with all its bytes.
std::string_view first_character(std::string_view text);

}  // namespace blossom
