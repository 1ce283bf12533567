#include "doubles.hpp"

#include <blossom/rational/double_conversion.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <system_error>

namespace blossom::protocol {

namespace {

/// Of a number outside the range of doubles, without sign and prefix: whether it is too small, not too large.
bool is_below_one(std::string_view number, bool hexadecimal) {
    const std::string_view significand = number.substr(0, number.find_first_of(hexadecimal ? "pP" : "eE"));
    const std::size_t point = std::min(significand.find('.'), significand.size());
    const std::size_t first = significand.find_first_not_of("0.");
    std::string_view scale = number.substr(std::min(significand.size() + 1, number.size()));
    if (scale.starts_with('+')) scale.remove_prefix(1);
    std::ptrdiff_t exponent = 0;
    const auto read = std::from_chars(scale.data(), scale.data() + scale.size(), exponent);
    if (read.ec == std::errc::result_out_of_range) return scale.starts_with('-');
    const std::ptrdiff_t digits = static_cast<std::ptrdiff_t>(point) - static_cast<std::ptrdiff_t>(first);
    constexpr std::ptrdiff_t far = std::ptrdiff_t{1} << 40;
    return digits * (hexadecimal ? 4 : 1) + std::clamp(exponent, -far, far) < 0;
}

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
        if (is_below_one(digits, hexadecimal)) return negative ? -0.0 : 0.0;
        throw Error(ErrorCode::overflow, quoted(text) + " is beyond the range of doubles");
    }
    if (problem != std::errc{} || !all || !std::isfinite(value)) {
        throw Error(ErrorCode::not_a_number, quoted(text) + " is not a double");
    }
    return negative ? -value : value;
}

}  // namespace

Rational read_double(const Json& value) {
    if (const Rational* exact = value.exact()) return *exact;
    if (const Json::Number* number = value.number()) return exact_rational(parsed(number->text));
    if (const std::string* text = value.text()) return exact_rational(parsed(*text));
    throw Error(ErrorCode::not_a_number, "expected a number, found " + std::string(type_name(value)));
}

Json::Number double_number(const Rational& value) {
    const double nearest = nearest_double(value);
    // Without the point, many readers take it for an integer, which has no sign of zero.
    if (nearest == 0 && std::signbit(nearest)) return {"-0.0"};
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), nearest).ptr;
    return {{digits.data(), end}};
}

}  // namespace blossom::protocol
