#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>
#include <blossom/rational/resource_budget.hpp>
#include <blossom/rational/utf8.hpp>

#include <algorithm>
#include <charconv>
#include <optional>

#include "backend.hpp"

namespace blossom {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::size_t digits_length(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::find_if_not(text, is_digit) - text.begin());
}

[[noreturn]] void fail(std::string_view text) {
    throw Error(
        ErrorCode::not_a_number,
        quoted(text) + R"( is not an exact number; write it as "p", "p/q" or a decimal such as "-0.125")");
}

/// The value of decimal digits; nullopt for any other text. The value of "" is 0.
std::optional<Integer> integer_from_digits(std::string_view digits, const Limits& limits) {
    while (digits.starts_with('0')) digits.remove_prefix(1);
    constexpr std::size_t most_in_word = 18;
    const bool in_word = digits.size() <= most_in_word;
    std::int64_t value = 0;
    for (const char c : digits) {
        if (!is_digit(c)) return std::nullopt;
        if (in_word) value = 10 * value + (c - '0');
    }
    require_within(digits.size(), limits.digits, "digits", "a number whose count of digits is");
    if (in_word) return value;
    return IntegerAccess::from_number(backend::Number(std::string(digits)));
}

/// A decimal exponent; one that does not fit in the type is far beyond every limit.
std::size_t exponent_from_digits(std::string_view digits, const Limits& limits) {
    std::size_t value = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (problem != std::errc{} || value > limits.digits) {
        throw limit_error("the decimal exponent " + std::string(digits.substr(0, 40)) + " exceeds", "digits",
                          limits.digits);
    }
    return value;
}

/// The value of an unsigned decimal that `unsigned_decimal_length` recognised.
Rational decimal(std::string_view text, const Limits& limits) {
    const std::string_view whole = text.substr(0, digits_length(text));
    text.remove_prefix(whole.size());
    std::string_view fraction;
    if (text.starts_with('.')) {
        fraction = text.substr(1, digits_length(text.substr(1)));
        text.remove_prefix(1 + fraction.size());
    }
    bool negative_exponent = false;
    std::size_t exponent = 0;
    if (!text.empty()) {
        text.remove_prefix(1);
        negative_exponent = text.starts_with('-');
        if (negative_exponent || text.starts_with('+')) text.remove_prefix(1);
        exponent = exponent_from_digits(text, limits);
    }
    if (fraction.empty() && exponent == 0) return *integer_from_digits(whole, limits);
    require_within(whole.size() + fraction.size() + exponent, limits.digits, "digits",
                   "a decimal whose count of digits, with those of its exponent, is");
    const Integer digits = *integer_from_digits(std::string(whole) + std::string(fraction), limits);
    const Integer scale = pow(Integer(10), exponent);
    const Integer point = pow(Integer(10), fraction.size());
    return negative_exponent ? Rational(digits, point * scale) : Rational(digits * scale, point);
}

/// Whether the byte at `place` continues a UTF-8 character that begins before it.
bool continues_at(std::string_view text, std::size_t place) {
    return place < text.size() && continues_character(text[place]);
}

}  // namespace

std::string_view first_character(std::string_view text) {
    std::size_t length = std::min<std::size_t>(text.size(), 1);
    while (continues_at(text, length)) ++length;
    return text.substr(0, length);
}

std::string quoted(std::string_view text) {
    constexpr std::size_t longest = 40;
    std::size_t length = std::min(longest, text.size());
    while (length > 0 && continues_at(text, length)) --length;
    std::string result = "\"";
    for (const char c : text.substr(0, length)) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x20 && byte != 0x7f) {
            result += c;
        } else {
            constexpr std::string_view hex = "0123456789abcdef";
            result += "\\x";
            result += hex[byte >> 4];
            result += hex[byte & 15];
        }
    }
    result += text.size() > longest ? "...\"" : "\"";
    return result;
}

std::size_t unsigned_decimal_length(std::string_view text) {
    std::size_t length = digits_length(text);
    if (length == 0) return 0;
    if (length < text.size() && text[length] == '.') {
        const std::size_t fraction = digits_length(text.substr(length + 1));
        if (fraction != 0) length += 1 + fraction;
    }
    if (length < text.size() && (text[length] == 'e' || text[length] == 'E')) {
        std::size_t start = length + 1;
        if (start < text.size() && (text[start] == '-' || text[start] == '+')) ++start;
        const std::size_t exponent = digits_length(text.substr(std::min(start, text.size())));
        if (exponent != 0) length = start + exponent;
    }
    return length;
}

Rational parse_rational(std::string_view text, const Limits& limits) {
    std::string_view rest = text;
    const bool negative = rest.starts_with('-');
    if (negative) rest.remove_prefix(1);
    const auto signed_value = [&](Rational value) { return negative ? -std::move(value) : value; };

    const auto slash = static_cast<std::size_t>(std::ranges::find(rest, '/') - rest.begin());
    if (slash == rest.size()) {
        if (rest.empty() || unsigned_decimal_length(rest) != rest.size()) fail(text);
        return signed_value(decimal(rest, limits));
    }
    const std::string_view above = rest.substr(0, slash);
    const std::string_view below = rest.substr(slash + 1);
    if (above.empty() || below.empty()) fail(text);
    auto numerator = integer_from_digits(above, limits);
    auto denominator = integer_from_digits(below, limits);
    if (!numerator || !denominator) fail(text);
    if (denominator->is_zero())
        throw Error(ErrorCode::zero_denominator, quoted(text) + " has a zero denominator");
    return signed_value({*std::move(numerator), *std::move(denominator)});
}

Integer parse_integer(std::string_view text, const Limits& limits) {
    const std::string_view digits = text.substr(text.starts_with('-') ? 1 : 0);
    auto value = integer_from_digits(digits, limits);
    if (digits.empty() || !value) throw Error(ErrorCode::not_a_number, quoted(text) + " is not an integer");
    return text.starts_with('-') ? -*std::move(value) : *std::move(value);
}

std::string to_string(const Integer& value) {
    if (const auto small = value.to_int64()) return std::to_string(*small);
    const std::size_t words = value.bit_length() / 64;
    spend_work(2 * words_of_product(words, words));
    return IntegerAccess::to_number(value).str();
}

}  // namespace blossom
