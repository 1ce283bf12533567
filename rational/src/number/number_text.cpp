#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>
#include <blossom/rational/resource_budget.hpp>
#include <blossom/rational/utf8.hpp>
#include <blossom/rational/written_marks.hpp>

#include <algorithm>
#include <charconv>

#include "backend.hpp"
#include "rational_access.hpp"

namespace blossom {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_hexadecimal_digit(char c) { return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

/// How many characters at the front of `text` are digits.
std::size_t digits_length(std::string_view text, bool (*belongs)(char) = is_digit) {
    return static_cast<std::size_t>(std::ranges::find_if_not(text, belongs) - text.begin());
}

/// The length of "e-3" at the front of `text`, where e is one of `letters`; 0 when there is no exponent.
std::size_t exponent_length(std::string_view text, std::string_view letters) {
    if (text.empty() || letters.find(text.front()) == std::string_view::npos) return 0;
    const bool has_sign = text.size() > 1 && (text[1] == '-' || text[1] == '+');
    const std::size_t begin = has_sign ? 2 : 1;
    const std::size_t digits = digits_length(text.substr(begin));
    return digits == 0 ? 0 : begin + digits;
}

/// The length of "0x1.8p-3" at the front of `text`.
std::size_t hexadecimal_length(std::string_view text) {
    if (!text.starts_with("0x") && !text.starts_with("0X")) return 0;
    std::size_t length = 2 + digits_length(text.substr(2), is_hexadecimal_digit);
    std::size_t digits = length - 2;
    if (length < text.size() && text[length] == '.') {
        const std::size_t fraction = digits_length(text.substr(length + 1), is_hexadecimal_digit);
        length += 1 + fraction;
        digits += fraction;
    }
    const std::size_t exponent = exponent_length(text.substr(length), "pP");
    return digits == 0 || exponent == 0 ? 0 : length + exponent;
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
        std::size_t length = 0;
        for (; length != from.size() && is_digit(from[length]); ++length)
            word = 10 * word + static_cast<std::uint64_t>(from[length] - '0');
        text = from.substr(0, length);
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

/// An exponent; one that does not fit is far beyond every limit.
std::size_t exponent_from_digits(std::string_view digits, const Limits& limits) {
    std::size_t value = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (problem != std::errc{} || value > limits.digits) {
        throw limit_error("the decimal exponent " + std::string(digits.substr(0, 40)) + " exceeds", "digits",
                          limits.digits);
    }
    return value;
}

/// The value of a text of decimal digits; none for another text.
std::optional<Integer> integer_from_text(std::string_view text, const Limits& limits) {
    const Digits digits(text);
    if (digits.size() != text.size()) return std::nullopt;
    return integer_from_digits(digits, limits);
}

/// An exponent with its sign.
struct Exponent {
    std::size_t size = 0;
    bool negative = false;
};
Exponent exponent_from_text(std::string_view text, const Limits& limits) {
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) text.remove_prefix(1);
    return {exponent_from_digits(text, limits), negative};
}

/// The digits on both sides of a point at the front of `text`, which is cut off.
struct PointedDigits {
    std::string_view whole;
    std::string_view fraction;
};
PointedDigits take_digits(std::string_view& text, bool (*belongs)(char)) {
    PointedDigits digits{text.substr(0, digits_length(text, belongs)), {}};
    text.remove_prefix(digits.whole.size());
    if (!text.starts_with('.')) return digits;
    digits.fraction = text.substr(1, digits_length(text.substr(1), belongs));
    text.remove_prefix(1 + digits.fraction.size());
    return digits;
}

Rational decimal(std::string_view text, const Limits& limits) {
    const auto [whole, fraction] = take_digits(text, is_digit);
    const Exponent exponent = text.empty() ? Exponent{} : exponent_from_text(text.substr(1), limits);
    if (fraction.empty() && exponent.size == 0) return *integer_from_text(whole, limits);
    require_within(whole.size() + fraction.size() + exponent.size, limits.digits, "digits",
                   "a decimal whose count of digits, with those of its exponent, is");
    const Integer digits = *integer_from_text(std::string(whole) + std::string(fraction), limits);
    const Integer scale = pow(Integer(10), exponent.size);
    const Integer point = pow(Integer(10), fraction.size());
    return exponent.negative ? Rational(digits, point * scale) : Rational(digits * scale, point);
}

Rational hexadecimal(std::string_view text, const Limits& limits) {
    text.remove_prefix(2);
    const auto [whole, fraction] = take_digits(text, is_hexadecimal_digit);
    const Exponent exponent = exponent_from_text(text.substr(1), limits);
    std::string digits = std::string(whole) + std::string(fraction);
    const std::size_t point = 4 * fraction.size();
    require_within((4 * digits.size() + exponent.size) / 3, limits.digits, "digits",
                   "a hexadecimal number whose count of decimal digits is up to");
    digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
    const Integer significand = IntegerAccess::from_number(backend::Number("0x" + digits));
    if (exponent.negative) return {significand, Integer(1) << (point + exponent.size)};
    return {significand << exponent.size, Integer(1) << point};
}

/// An unsigned number that `unsigned_number_length` has measured.
Rational unsigned_number(std::string_view text, const Limits& limits) {
    if (hexadecimal_length(text) == text.size()) return hexadecimal(text, limits);
    const std::size_t digits = digits_length(text);
    const VulgarFraction fraction = vulgar_fraction(text.substr(digits));
    if (fraction.length == 0) return decimal(text, limits);
    return Rational(*integer_from_text(text.substr(0, digits), limits)) +
           Rational(fraction.numerator, fraction.denominator);
}

/// p/q.
Rational quotient(std::string_view text, std::string_view above, std::string_view below,
                  const Limits& limits) {
    if (above.empty() || below.empty()) fail(text);
    auto numerator = integer_from_text(above, limits);
    auto denominator = integer_from_text(below, limits);
    if (!numerator || !denominator) fail(text);
    if (denominator->is_zero())
        throw Error(ErrorCode::zero_denominator, quoted(text) + " has a zero denominator");
    return {*std::move(numerator), *std::move(denominator)};
}

/// The power of an integer whose digits stand before an exponent, "2^-53" or "10⁻³".
Rational power(std::string_view text, std::string_view base, std::string_view behind, const Limits& limits) {
    Superscript raised = superscript(behind);
    if (raised.length == 0) {
        const WrittenMark mark = written_mark(behind);
        if (mark.meaning != '^') fail(text);
        std::string_view exponent = behind.substr(mark.length);
        if (const WrittenMark sign = written_mark(exponent); sign.meaning == '-') {
            raised.digits = "-";
            exponent.remove_prefix(sign.length);
        }
        const std::size_t digits = digits_length(exponent);
        if (digits == 0) fail(text);
        raised.digits += exponent.substr(0, digits);
        raised.length = behind.size() - exponent.size() + digits;
    }
    const auto value = integer_from_text(base, limits);
    if (base.empty() || !value || raised.length != behind.size()) fail(text);
    const Exponent exponent = exponent_from_text(raised.digits, limits);
    require_within(value->bit_length() * exponent.size / 3, limits.digits, "digits",
                   "a power whose count of decimal digits is up to");
    if (!exponent.negative) return pow(*value, exponent.size);
    if (value->is_zero()) throw Error(ErrorCode::zero_denominator, quoted(text) + " has a zero denominator");
    return {Integer(1), pow(*value, exponent.size)};
}

/// A number that goes on with a mark behind its first `length` bytes.
Rational marked_number(std::string_view text, std::string_view rest, std::size_t length,
                       const Limits& limits) {
    const std::string_view front = rest.substr(0, length);
    const std::string_view behind = rest.substr(length);
    const WrittenMark mark = written_mark(behind);
    const std::string_view next = behind.substr(mark.length);
    if (mark.meaning == '/') return quotient(text, front, next, limits);
    if (mark.meaning != '*') return power(text, front, behind, limits);
    const std::size_t digits = digits_length(next);
    return unsigned_number(front, limits) * power(text, next.substr(0, digits), next.substr(digits), limits);
}

/// "p" or "p/q" of decimal digits that are words; none for another text.
std::optional<Rational> rational_in_words(std::string_view text, const Limits& limits) {
    const bool negative = text.starts_with('-');
    if (negative) text.remove_prefix(1);
    const Digits above(text);
    if (above.empty() || !above.are_word(limits)) return std::nullopt;
    const auto magnitude = static_cast<std::int64_t>(above.word);
    const std::int64_t numerator = negative ? -magnitude : magnitude;
    text.remove_prefix(above.size());
    if (text.empty()) return Rational(numerator);
    if (text.front() != '/') return std::nullopt;
    const Digits below(text.substr(1));
    if (below.size() + 1 != text.size() || !below.are_word(limits) || below.word == 0) return std::nullopt;
    return RationalAccess::from_words(numerator, static_cast<std::int64_t>(below.word));
}

/// Whether the byte at `place` continues a character.
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

std::size_t unsigned_number_length(std::string_view text) {
    if (const std::size_t hexadecimal = hexadecimal_length(text)) return hexadecimal;
    std::size_t length = digits_length(text);
    const bool has_whole = length > 0;
    if (const VulgarFraction fraction = vulgar_fraction(text.substr(length)); fraction.length != 0)
        return length + fraction.length;
    if (length < text.size() && text[length] == '.') {
        const std::size_t fraction = digits_length(text.substr(length + 1));
        const bool is_range = text.substr(length).starts_with("..");
        if (fraction != 0 || (has_whole && !is_range)) length += 1 + fraction;
    }
    return length == 0 ? 0 : length + exponent_length(text.substr(length), "eE");
}

Rational parse_rational(std::string_view text, const Limits& limits) {
    if (const auto value = rational_in_words(text, limits)) return *value;
    std::string_view rest = text;
    const WrittenMark sign = written_mark(text);
    const bool negative = sign.meaning == '-';
    if (negative) rest.remove_prefix(sign.length);
    const auto signed_value = [&](Rational value) { return negative ? -std::move(value) : value; };
    if (rest.empty()) fail(text);
    if (auto whole = integer_from_text(rest, limits)) return signed_value(*std::move(whole));

    const auto slash = static_cast<std::size_t>(std::ranges::find(rest, '/') - rest.begin());
    if (slash != rest.size())
        return signed_value(quotient(text, rest.substr(0, slash), rest.substr(slash + 1), limits));
    const std::size_t length = unsigned_number_length(rest);
    if (length == 0) fail(text);
    if (length == rest.size()) return signed_value(unsigned_number(rest, limits));
    return signed_value(marked_number(text, rest, length, limits));
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
