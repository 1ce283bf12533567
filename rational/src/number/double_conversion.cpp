#include <blossom/rational/double_conversion.hpp>
#include <blossom/rational/error.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

namespace blossom {

namespace {

constexpr int significand_bits = std::numeric_limits<double>::digits;
constexpr std::ptrdiff_t least_exponent = std::numeric_limits<double>::min_exponent - significand_bits;
constexpr std::ptrdiff_t greatest_exponent = std::numeric_limits<double>::max_exponent - significand_bits;

Integer shifted(const Integer& value, std::ptrdiff_t bits) {
    return bits > 0 ? value << static_cast<std::size_t>(bits) : value;
}

[[noreturn]] void overflow(const Rational& value) {
    throw Error(ErrorCode::overflow,
                "a number of about 2^" +
                    std::to_string(value.numerator().bit_length() - value.denominator().bit_length()) +
                    " is beyond the range of a double");
}

/// The exponent e of the distance 2^e between doubles at `value`, which is not 0: 2^(e + 52) <= |value| <
/// 2^(e + 53), of which only the second inequality holds if e is the least exponent. Errors: `overflow` for
/// |value| >= 2^1024.
std::ptrdiff_t unit_exponent(const Rational& value) {
    const Integer numerator = abs(value.numerator());
    const Integer& denominator = value.denominator();
    const std::ptrdiff_t binade = static_cast<std::ptrdiff_t>(numerator.bit_length()) -
                                  static_cast<std::ptrdiff_t>(denominator.bit_length());
    const bool above = shifted(numerator, -binade) >= shifted(denominator, binade);
    const std::ptrdiff_t exponent = std::max(binade - significand_bits + (above ? 1 : 0), least_exponent);
    if (exponent > greatest_exponent) overflow(value);
    return exponent;
}

/// |value| = significand * 2^exponent rounded to 53 bits (fewer when subnormal), ties to even.
struct Rounded {
    std::int64_t significand;
    std::ptrdiff_t exponent;
};

Rounded round_magnitude(const Rational& value) {
    const std::ptrdiff_t exponent = unit_exponent(value);
    const Integer dividend = shifted(abs(value.numerator()), -exponent);
    const Integer divisor = shifted(value.denominator(), exponent);
    Integer quotient = dividend / divisor;
    const Integer twice_remainder = (dividend % divisor) * 2;
    if (twice_remainder > divisor || (twice_remainder == divisor && quotient.is_odd())) quotient += 1;
    return {*quotient.to_int64(), exponent};
}

}  // namespace

Rational exact_rational(double value) {
    if (!std::isfinite(value)) {
        throw Error(ErrorCode::not_a_number, "NaN and infinities are not rational numbers");
    }
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    const Integer significand = static_cast<std::int64_t>(std::ldexp(fraction, significand_bits));
    const int shift = exponent - significand_bits;
    return {shifted(significand, shift), shifted(1, -shift)};
}

double nearest_double(const Rational& value) {
    if (value.is_zero()) return 0;
    const auto [significand, exponent] = round_magnitude(value);
    const double magnitude = std::ldexp(static_cast<double>(significand), static_cast<int>(exponent));
    if (std::isinf(magnitude)) overflow(value);
    return value.sign() < 0 ? -magnitude : magnitude;
}

Rational unit_in_last_place(const Rational& value) {
    const std::ptrdiff_t exponent = value.is_zero() ? least_exponent : unit_exponent(value);
    return {shifted(1, exponent), shifted(1, -exponent)};
}

std::string hexadecimal_float(const Rational& value) {
    const double number = nearest_double(value);
    std::array<char, 32> digits{};
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), std::fabs(number), std::chars_format::hex)
            .ptr;
    return (std::signbit(number) ? "-0x" : "0x") + std::string(digits.data(), end);
}

}  // namespace blossom
