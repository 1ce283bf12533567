#pragma once

#include <blossom/rational/rational_vector.hpp>

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>

namespace blossom {

/// A polynomial over Q in one variable, dense, as integers over one common denominator.
///
/// It is an element of the ring Q[t]: its degree is the actual degree, and there are no leading zeros. The
/// zero polynomial has no coefficients and degree 0. A formal degree belongs to a map, see `PolynomialCurve`.
class Polynomial {
public:
    Polynomial() = default;
    Polynomial(const Rational& constant);  // NOLINT(google-explicit-constructor): a constant is a polynomial
    template <WholeNumber Word>
    Polynomial(Word constant) : Polynomial(Rational(constant)) {}  // NOLINT(google-explicit-constructor)
    /// The coefficients are given lowest first; leading zeros are dropped, and the denominator is reduced to
    /// the least.
    explicit Polynomial(const RationalVector& coefficients);
    explicit Polynomial(std::span<const Rational> coefficients) : Polynomial(RationalVector(coefficients)) {}
    Polynomial(std::initializer_list<Rational> coefficients)
        : Polynomial(std::span(coefficients.begin(), coefficients.size())) {}
    /// t^k.
    static Polynomial monomial(Count k);

    bool is_zero() const { return coefficients_.empty(); }
    std::size_t degree() const { return is_zero() ? 0 : coefficients_.size() - 1; }
    /// The degree() + 1 coefficients, or none for zero.
    const RationalVector& coefficients() const { return coefficients_; }
    /// The coefficient of t^k; 0 beyond the degree.
    Rational operator[](std::size_t k) const {
        return k < coefficients_.size() ? coefficients_[k] : Rational();
    }
    Rational leading_coefficient() const { return (*this)[degree()]; }

    Polynomial& operator+=(const Polynomial& other) { return *this = *this + other; }
    Polynomial& operator-=(const Polynomial& other) { return *this = *this - other; }
    Polynomial& operator*=(const Polynomial& other) { return *this = *this * other; }
    friend Polynomial operator+(const Polynomial& a, const Polynomial& b);
    friend Polynomial operator-(const Polynomial& a, const Polynomial& b);
    /// Cost: one `product` of the numerators.
    friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
    friend Polynomial operator-(const Polynomial& a);
    friend bool operator==(const Polynomial&, const Polynomial&) = default;
    /// As `to_text` with the variable t.
    friend std::string to_string(const Polynomial& polynomial);
    friend std::size_t hash_value(const Polynomial& polynomial) { return hash_of(polynomial.coefficients_); }

    /// P(t) by Horner's rule on integers. Cost: n multiplications on numbers that grow to n times the bits of
    /// t.
    Rational operator()(const Rational& t) const;

private:
    RationalVector coefficients_;
};

/// P(Q(t)) by Horner's rule. Cost: deg P products of polynomials.
Polynomial compose(const Polynomial& outer, const Polynomial& inner);

/// P'. The function `derivative` of a map gives derivatives of any order.
Polynomial derivative(const Polynomial& polynomial);

/// Quotient and remainder: a = quotient * b + remainder with the remainder of smaller degree, or zero.
/// Errors: `division_by_zero`.
std::pair<Polynomial, Polynomial> divide(const Polynomial& a, const Polynomial& b);

/// a / b where b divides a. Errors: `inexact_division` if b does not divide a, `division_by_zero`.
Polynomial divide_exactly(const Polynomial& a, const Polynomial& b);

/// The monic greatest common divisor, by a primitive remainder sequence; gcd(0, 0) = 0.
/// Cost: (deg a)(deg b) operations on integers whose length grows with the degrees.
Polynomial gcd(const Polynomial& a, const Polynomial& b);

/// base^exponent, with 0^0 = 1. Errors: `limit_exceeded` for a degree above `Limits::numbers`.
Polynomial pow(const Polynomial& base, Count exponent);

}  // namespace blossom
