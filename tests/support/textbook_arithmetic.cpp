#include "textbook_arithmetic.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include <cmath>
#include <limits>

namespace blossom::textbook {

namespace {

using Number = boost::multiprecision::cpp_int;
using Fraction = boost::multiprecision::cpp_rational;

Number number(const Integer& value) { return Number(to_string(value)); }

Fraction fraction(const Rational& value) { return {number(value.numerator()), number(value.denominator())}; }

std::string text(const Fraction& value) {
    const Number denominator = boost::multiprecision::denominator(value);
    std::string result = boost::multiprecision::numerator(value).str();
    if (denominator != 1) result.append("/").append(denominator.str());
    return result;
}

/// The double as a fraction: its significand times a power of two.
Fraction fraction(double value) {
    int exponent = 0;
    const auto significand = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
    exponent -= 53;
    const Fraction power = Number(1) << static_cast<unsigned>(std::abs(exponent));
    return exponent < 0 ? Fraction(significand) / power : Fraction(significand) * power;
}

bool has_even_significand(double value) {
    int exponent = 0;
    const double fraction_part = std::frexp(std::fabs(value), &exponent);
    const int digits = std::min(53, exponent + 1074);
    return std::fmod(std::ldexp(fraction_part, digits), 2.0) == 0.0;
}

int sign_of(int comparison) { return (comparison > 0) - (comparison < 0); }

}  // namespace

std::string sum(const Integer& a, const Integer& b) { return Number(number(a) + number(b)).str(); }
std::string difference(const Integer& a, const Integer& b) { return Number(number(a) - number(b)).str(); }
std::string product(const Integer& a, const Integer& b) { return Number(number(a) * number(b)).str(); }
std::string quotient(const Integer& a, const Integer& b) { return Number(number(a) / number(b)).str(); }
std::string remainder(const Integer& a, const Integer& b) { return Number(number(a) % number(b)).str(); }

std::string greatest_common_divisor(const Integer& a, const Integer& b) {
    Number x = abs(number(a));
    Number y = abs(number(b));
    while (y != 0) {
        Number rest = x % y;
        x = std::move(y);
        y = std::move(rest);
    }
    return x.str();
}

std::string least_common_multiple(const Integer& a, const Integer& b) {
    if (a.is_zero() || b.is_zero()) return "0";
    const Number common(greatest_common_divisor(a, b));
    return Number(abs(number(a) * number(b)) / common).str();
}

std::string power(const Integer& base, unsigned exponent) {
    const Number factor = number(base);
    Number result = 1;
    for (unsigned i = 0; i < exponent; ++i) result *= factor;
    return result.str();
}

std::string left_shifted(const Integer& a, unsigned bits) {
    Number value = number(a);
    for (unsigned i = 0; i < bits; ++i) value *= 2;
    return value.str();
}

std::string right_shifted(const Integer& a, unsigned bits) {
    const Number divisor = Number(1) << bits;
    const Number value = number(a);
    Number result = value / divisor;
    if (value < 0 && result * divisor != value) result -= 1;
    return result.str();
}

std::size_t bit_length(const Integer& a) {
    const Number value = abs(number(a));
    return value == 0 ? 0 : boost::multiprecision::msb(value) + 1;
}

int comparison(const Integer& a, const Integer& b) { return sign_of(number(a).compare(number(b))); }

std::string sum(const Rational& a, const Rational& b) { return text(fraction(a) + fraction(b)); }
std::string difference(const Rational& a, const Rational& b) { return text(fraction(a) - fraction(b)); }
std::string product(const Rational& a, const Rational& b) { return text(fraction(a) * fraction(b)); }
std::string quotient(const Rational& a, const Rational& b) { return text(fraction(a) / fraction(b)); }

std::string power(const Rational& base, unsigned exponent) {
    const Fraction factor = fraction(base);
    Fraction result = 1;
    for (unsigned i = 0; i < exponent; ++i) result *= factor;
    return text(result);
}

int comparison(const Rational& a, const Rational& b) { return sign_of(fraction(a).compare(fraction(b))); }

std::string lowest_terms(const Integer& p, const Integer& q) {
    return text(Fraction(number(p)) / Fraction(number(q)));
}

std::string decimal_of(std::int64_t significand, int exponent) {
    Number digits = significand;
    for (int i = 0; i < std::abs(exponent); ++i) digits *= exponent < 0 ? 5 : 2;
    std::string result = digits.str();
    if (exponent < 0) result.append("e").append(std::to_string(exponent));
    return result;
}

bool is_nearest(double candidate, const Rational& value) {
    if (!std::isfinite(candidate)) return false;
    const Fraction target = fraction(value);
    const Fraction distance = abs(fraction(candidate) - target);
    for (const double end :
         {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}) {
        const double neighbour = std::nextafter(candidate, end);
        if (!std::isfinite(neighbour)) continue;
        const Fraction other = abs(fraction(neighbour) - target);
        if (other < distance || (other == distance && !has_even_significand(candidate))) return false;
    }
    return true;
}

}  // namespace blossom::textbook
