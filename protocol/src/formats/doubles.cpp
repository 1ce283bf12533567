#include "doubles.hpp"

#include <blossom/rational/double_conversion.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace blossom::protocol {

namespace {

/// The double nearest to a text, which is the whole of it.
double parsed(std::string_view text) {
    const bool negative = text.starts_with('-');
    std::string_view digits = negative ? text.substr(1) : text;
    const bool hexadecimal = digits.starts_with("0x");
    if (hexadecimal) digits.remove_prefix(2);
    double value = 0;
    const auto [end, problem] =
        std::from_chars(digits.data(), digits.data() + digits.size(), value,
                        hexadecimal ? std::chars_format::hex : std::chars_format::general);
    const bool all = end == digits.data() + digits.size() && !digits.empty() && digits.front() != '-';
    if (problem == std::errc::result_out_of_range && all) {
        throw Error(ErrorCode::overflow, quoted(text) + " is beyond the range of doubles");
    }
    if (problem != std::errc{} || !all || !std::isfinite(value)) {
        throw Error(ErrorCode::not_a_number, quoted(text) + " is not a double");
    }
    return negative ? -value : value;
}

}  // namespace

Rational read_double(const Json& value) {
    if (const Json::Number* number = value.number()) return exact_rational(parsed(number->text));
    if (const std::string* text = value.text()) return exact_rational(parsed(*text));
    throw Error(ErrorCode::not_a_number, "expected a number, found " + std::string(type_name(value)));
}

Json::Number double_number(const Rational& value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), nearest_double(value)).ptr;
    return {{digits.data(), end}};
}

Rational unit_in_last_place(const Rational& value) {
    const double nearest = std::abs(nearest_double(value));
    const double above = std::nextafter(nearest, std::numeric_limits<double>::infinity());
    // The greatest double has none above; the distance to the one below is the same.
    if (!std::isfinite(above)) return exact_rational(nearest) - exact_rational(std::nextafter(nearest, 0.0));
    return exact_rational(above) - exact_rational(nearest);
}

}  // namespace blossom::protocol
