#pragma once

#include <blossom/rational/integer.hpp>

#include <compare>
#include <cstddef>
#include <string>
#include <utility>

namespace blossom {

/// A rational number in lowest terms with a positive denominator; zero is 0/1. Equal values have equal
/// representations.
///
/// Cost: each operation reduces its result with one gcd of numbers of its size. Computations that combine
/// many numbers use integers over one common denominator: see `RationalVector`.
class Rational {
public:
    Rational() = default;
    Rational(Integer value)  // NOLINT(google-explicit-constructor): an integer is a rational number
        : numerator_(std::move(value)) {}
    template <WholeNumber Word>
    Rational(Word value) : numerator_(value) {}  // NOLINT(google-explicit-constructor)
    /// numerator / denominator, reduced. Errors: `zero_denominator`.
    Rational(Integer numerator, Integer denominator);

    Rational(const Rational&) = default;
    /// Leaves a valid number behind, as the assignment does.
    Rational(Rational&& other) noexcept
        : numerator_(std::move(other.numerator_)), denominator_(std::exchange(other.denominator_, 1)) {}
    Rational& operator=(const Rational&) = default;
    Rational& operator=(Rational&&) noexcept = default;
    ~Rational() = default;

    const Integer& numerator() const { return numerator_; }
    const Integer& denominator() const { return denominator_; }
    int sign() const { return numerator_.sign(); }
    bool is_zero() const { return numerator_.is_zero(); }
    bool is_integer() const { return denominator_.is_one(); }

    Rational& operator+=(const Rational& other);
    Rational& operator-=(const Rational& other);
    Rational& operator*=(const Rational& other);
    /// Errors: `division_by_zero`.
    Rational& operator/=(const Rational& other);

    friend Rational operator+(Rational a, const Rational& b) { return std::move(a += b); }
    friend Rational operator-(Rational a, const Rational& b) { return std::move(a -= b); }
    friend Rational operator*(Rational a, const Rational& b) { return std::move(a *= b); }
    friend Rational operator/(Rational a, const Rational& b) { return std::move(a /= b); }
    friend Rational operator-(Rational a) {
        a.numerator_.negate();
        return a;
    }
    friend bool operator==(const Rational& a, const Rational& b) = default;
    friend std::strong_ordering operator<=>(const Rational& a, const Rational& b);

private:
    friend struct RationalAccess;

    /// Marks a quotient that is in lowest terms and has a positive denominator.
    struct Reduced {};
    Rational(Integer numerator, Integer denominator, Reduced)
        : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {}

    Rational& add(const Rational& other, bool subtract);

    Integer numerator_;
    Integer denominator_ = 1;
};

Rational abs(Rational value);
/// base^exponent, with 0^0 = 1; a negative exponent inverts. Errors: `division_by_zero`; `limit_exceeded`, as
/// for powers of integers.
Rational pow(const Rational& base, const Integer& exponent);

/// (left a + right b) / divisor in lowest terms. Cost: one gcd of the denominators of a and b, and one of the
/// numerator and each factor of the denominator; single operations would reduce four times. Errors:
/// `zero_denominator`.
Rational combination(const Integer& left, const Rational& a, const Integer& right, const Rational& b,
                     const Integer& divisor);

/// "p" or "p/q" in lowest terms.
std::string to_string(const Rational& value);

inline std::size_t hash_value(const Rational& value) {
    return hash_of(value.numerator(), value.denominator());
}

}  // namespace blossom
