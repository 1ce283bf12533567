#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>
#include <blossom/rational/resource_budget.hpp>
#include <blossom/rational/utf8.hpp>

#include <algorithm>
#include <charconv>

#include "backend.hpp"
#include "rational_access.hpp"

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

/// The decimal digits that a text begins with.
struct Digits {
    static constexpr std::size_t most_in_word = 18;

    std::string_view text;
    std::uint64_t word = 0;  ///< their value modulo 2^64

    explicit Digits(std::string_view from) {
        const char* at = from.data();
        const char* const end = at + from.size();
        for (; at != end && is_digit(*at); ++at) word = 10 * word + static_cast<std::uint64_t>(*at - '0');
        text = {from.data(), at};
    }
    bool empty() const { return text.empty(); }
    std::size_t size() const { return text.size(); }
    /// Whether they are surely a word and within the limits.
    bool are_word(const Limits& limits) const { return size() <= std::min(most_in_word, limits.digits); }
};

Integer integer_from_many_digits(const Digits& digits, const Limits& limits) {
    const std::size_t zeros = std::min(digits.text.find_first_not_of('0'), digits.size());
    const std::string_view significant = digits.text.substr(zeros);
    require_within(significant.size(), limits.digits, "digits", "a number whose count of digits is");
    if (significant.size() <= Digits::most_in_word) return digits.word;
    return IntegerAccess::from_number(backend::Number(std::string(significant)));
}

/// The value of decimal digits; "" is 0.
Integer integer_from_digits(const Digits& digits, const Limits& limits) {
    return digits.are_word(limits) ? static_cast<std::int64_t>(digits.word)
                                   : integer_from_many_digits(digits, limits);
}

/// A decimal exponent; one that does not fit is far beyond every limit.
std::size_t exponent_from_digits(std::string_view digits, const Limits& limits) {
    std::size_t value = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (problem != std::errc{} || value > limits.digits) {
        throw limit_error("the decimal exponent " + std::string(digits.substr(0, 40)) + " exceeds", "digits",
                          limits.digits);
    }
    return value;
}

/// An unsigned decimal that `unsigned_decimal_length` has measured.
Rational decimal(std::string_view text, const Limits& limits) {
    const Digits whole(text);
    text.remove_prefix(whole.size());
    Digits fraction("");
    if (text.starts_with('.')) {
        fraction = Digits(text.substr(1));
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
    if (fraction.empty() && exponent == 0) return integer_from_digits(whole, limits);
    require_within(whole.size() + fraction.size() + exponent, limits.digits, "digits",
                   "a decimal whose count of digits, with those of its exponent, is");
    const std::string all = std::string(whole.text) + std::string(fraction.text);
    const Integer digits = integer_from_digits(Digits(all), limits);
    const Integer scale = pow(Integer(10), exponent);
    const Integer point = pow(Integer(10), fraction.size());
    return negative_exponent ? Rational(digits, point * scale) : Rational(digits * scale, point);
}

}  // namespace

namespace {

/// Whether a character goes on at `place`: all its bytes but the first have the form 10xxxxxx.
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
    const Digits above(rest);
    rest.remove_prefix(above.size());
    if (above.empty() || rest == "/") fail(text);
    if (!rest.empty() && rest.front() != '/') {
        const std::string_view magnitude = text.substr(negative ? 1 : 0);
        if (unsigned_decimal_length(magnitude) != magnitude.size()) fail(text);
        Rational value = decimal(magnitude, limits);
        return negative ? -std::move(value) : value;
    }
    if (rest.empty()) {
        Integer value = integer_from_digits(above, limits);
        return negative ? -std::move(value) : value;
    }
    rest.remove_prefix(1);
    const Digits below(rest);
    const bool is_complete = below.size() == rest.size();
    if (is_complete && above.are_word(limits) && below.are_word(limits) && below.word != 0) {
        const auto numerator = static_cast<std::int64_t>(above.word);
        return RationalAccess::from_words(negative ? -numerator : numerator,
                                          static_cast<std::int64_t>(below.word));
    }
    Integer numerator = integer_from_digits(above, limits);
    if (negative) numerator.negate();
    if (!is_complete) fail(text);
    Integer denominator = integer_from_digits(below, limits);
    if (denominator.is_zero())
        throw Error(ErrorCode::zero_denominator, quoted(text) + " has a zero denominator");
    return {std::move(numerator), std::move(denominator)};
}

Integer parse_integer(std::string_view text, const Limits& limits) {
    const std::string_view rest = text.substr(text.starts_with('-') ? 1 : 0);
    const Digits digits(rest);
    if (digits.empty() || digits.size() != rest.size())
        throw Error(ErrorCode::not_a_number, quoted(text) + " is not an integer");
    Integer value = integer_from_digits(digits, limits);
    return text.starts_with('-') ? -std::move(value) : value;
}

std::string to_string(const Integer& value) {
    if (const auto small = value.to_int64()) return std::to_string(*small);
    const std::size_t words = value.bit_length() / 64;
    spend_work(2 * words_of_product(words, words));
    return IntegerAccess::to_number(value).str();
}

}  // namespace blossom
