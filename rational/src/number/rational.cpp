#include <blossom/rational/error.hpp>
#include <blossom/rational/rational.hpp>

#include <limits>
#include <utility>

#include "rational_access.hpp"

namespace blossom {

Rational::Rational(Integer numerator, Integer denominator)
    : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {
    if (denominator_.is_zero()) {
        throw Error(ErrorCode::zero_denominator, to_string(numerator_) + "/0 has a zero denominator");
    }
    if (denominator_.sign() < 0) {
        numerator_.negate();
        denominator_.negate();
    }
    if (denominator_.is_one()) return;
    if (numerator_.is_word() && denominator_.is_word()) {
        *this = RationalAccess::from_words(numerator_.word(), denominator_.word());
        return;
    }
    const Integer common = gcd(numerator_, denominator_);
    if (common.is_one()) return;
    numerator_ = divide_exactly(numerator_, common);
    denominator_ = divide_exactly(denominator_, common);
}

// With g = gcd(b, d), the sum a/b + c/d = (a (d/g) + c (b/g)) / (b (d/g)), and its terms can share only
// factors of g (Knuth, 4.5.1).
Rational& Rational::add(const Rational& other, bool subtract) {
    const Integer common = gcd(denominator_, other.denominator_);
    const Integer cofactor = divide_exactly(other.denominator_, common);
    const Integer term = other.numerator_ * divide_exactly(denominator_, common);
    Integer sum = numerator_ * cofactor;
    subtract ? sum -= term : sum += term;
    const Integer excess = gcd(sum, common);
    denominator_ = divide_exactly(denominator_, excess) * cofactor;
    numerator_ = divide_exactly(sum, excess);
    return *this;
}

Rational& Rational::operator+=(const Rational& other) { return add(other, false); }

Rational& Rational::operator-=(const Rational& other) { return add(other, true); }

Rational& Rational::operator*=(const Rational& other) {
    const Integer left = gcd(numerator_, other.denominator_);
    const Integer right = gcd(other.numerator_, denominator_);
    Integer numerator = divide_exactly(numerator_, left) * divide_exactly(other.numerator_, right);
    Integer denominator = divide_exactly(denominator_, right) * divide_exactly(other.denominator_, left);
    numerator_ = std::move(numerator);
    denominator_ = std::move(denominator);
    return *this;
}

Rational& Rational::operator/=(const Rational& other) {
    if (other.is_zero())
        throw Error(ErrorCode::division_by_zero, to_string(*this) + " cannot be divided by 0");
    Rational inverse(other.denominator_, other.numerator_, Reduced{});
    if (inverse.denominator_.sign() < 0) {
        inverse.numerator_.negate();
        inverse.denominator_.negate();
    }
    return *this *= inverse;
}

std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    return a.numerator_ * b.denominator_ <=> b.numerator_ * a.denominator_;
}

Rational abs(Rational value) { return value.sign() < 0 ? -std::move(value) : value; }

Rational pow(const Rational& base, const Integer& exponent) {
    if (exponent.sign() < 0) return 1 / pow(base, -exponent);
    // Beyond words only the powers of 0, 1 and -1 are not refused; they depend on the parity.
    constexpr std::int64_t greatest_even = std::numeric_limits<std::int64_t>::max() - 1;
    const std::int64_t count = exponent.to_int64().value_or(greatest_even + (exponent.is_odd() ? 1 : 0));
    return RationalAccess::from_lowest_terms(pow(base.numerator(), count), pow(base.denominator(), count));
}

// The sum over the least common multiple g a' b' of the denominators g a' and g b'. After a factor f of the
// denominator and the numerator N are divided by gcd(N, f), f has no factor in common with N, nor with what
// later steps leave of N.
Rational combination(const Integer& left, const Rational& a, const Integer& right, const Rational& b,
                     const Integer& divisor) {
    const Integer common = gcd(a.denominator(), b.denominator());
    const Integer own_of_a = divide_exactly(a.denominator(), common);
    const Integer own_of_b = divide_exactly(b.denominator(), common);
    Integer numerator = left * a.numerator() * own_of_b;
    numerator.add_product(right * b.numerator(), own_of_a);
    Integer denominator = divisor * common * own_of_a * own_of_b;
    if (denominator.is_word()) return {std::move(numerator), std::move(denominator)};
    Integer shared = 1;
    for (const Integer* factor : {&divisor, &common, &own_of_a, &own_of_b}) {
        if (factor->is_one()) continue;
        const Integer with_factor = gcd(numerator, *factor);
        if (with_factor.is_one()) continue;
        numerator = divide_exactly(numerator, with_factor);
        shared *= with_factor;
    }
    if (!shared.is_one()) denominator = divide_exactly(denominator, shared);
    if (denominator.sign() < 0) {
        numerator.negate();
        denominator.negate();
    }
    return RationalAccess::from_lowest_terms(std::move(numerator), std::move(denominator));
}

std::string to_string(const Rational& value) {
    std::string text = to_string(value.numerator());
    if (!value.is_integer()) text += '/' + to_string(value.denominator());
    return text;
}

}  // namespace blossom
