#include <blossom/core/algebra/polynomial.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/integer_polynomials.hpp>
#include <blossom/rational/limits.hpp>

#include <algorithm>

namespace blossom {

namespace {

RationalVector trimmed(const RationalVector& coefficients) {
    std::vector<Integer> numerators = coefficients.numerators();
    while (!numerators.empty() && numerators.back().is_zero()) numerators.pop_back();
    RationalVector result = coefficients.over_same_denominator(std::move(numerators));
    result.make_canonical();
    return result;
}

/// a / da + sign * b / db over one denominator.
RationalVector combined(const RationalVector& a, const RationalVector& b, int sign) {
    const Integer denominator = lcm(a.denominator(), b.denominator());
    const Integer scale_a = divide_exactly(denominator, a.denominator());
    const Integer scale_b = divide_exactly(denominator, b.denominator()) * Integer(sign);
    std::vector<Integer> sums(std::max(a.size(), b.size()));
    for (std::size_t k = 0; k < a.size(); ++k) sums[k].add_product(a.numerators()[k], scale_a);
    for (std::size_t k = 0; k < b.size(); ++k) sums[k].add_product(b.numerators()[k], scale_b);
    return {std::move(sums), denominator};
}

Polynomial monic(const Polynomial& polynomial) {
    if (polynomial.is_zero()) return polynomial;
    return Polynomial(RationalVector(polynomial.coefficients().numerators(),
                                     polynomial.coefficients().numerators().back()));
}

}  // namespace

Polynomial::Polynomial(const Rational& constant) : Polynomial(RationalVector({&constant, 1})) {}

Polynomial::Polynomial(const RationalVector& coefficients) : coefficients_(trimmed(coefficients)) {}

Polynomial Polynomial::monomial(Count k) {
    std::vector<Integer> numerators(k + 1);
    numerators.back() = 1;
    return Polynomial(RationalVector(std::move(numerators), 1));
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
    return Polynomial(combined(a.coefficients_, b.coefficients_, 1));
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) {
    return Polynomial(combined(a.coefficients_, b.coefficients_, -1));
}

Polynomial operator-(const Polynomial& a) { return Polynomial() - a; }

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    return Polynomial(RationalVector(product(a.coefficients_.numerators(), b.coefficients_.numerators()),
                                     a.coefficients_.denominator() * b.coefficients_.denominator()));
}

Rational Polynomial::operator()(const Rational& t) const {
    if (is_zero()) return {};
    const auto& numerators = coefficients_.numerators();
    Integer value = numerators.back();
    Integer power = 1;
    for (std::size_t k = degree(); k-- > 0;) {
        power *= t.denominator();
        value = value * t.numerator() + numerators[k] * power;
    }
    return {value, coefficients_.denominator() * power};
}

Polynomial compose(const Polynomial& outer, const Polynomial& inner) {
    Polynomial value;
    for (std::size_t k = outer.coefficients().size(); k-- > 0;) value = value * inner + Polynomial(outer[k]);
    return value;
}

Polynomial derivative(const Polynomial& polynomial) {
    std::vector<Integer> numerators = polynomial.coefficients().numerators();
    if (numerators.size() < 2) return {};
    for (std::size_t k = 1; k < numerators.size(); ++k) numerators[k - 1] = numerators[k] * Integer(k);
    numerators.pop_back();
    return Polynomial(polynomial.coefficients().over_same_denominator(std::move(numerators)));
}

// Pseudo-division: every step multiplies by the leading coefficient of b instead of dividing by it.
std::pair<Polynomial, Polynomial> divide(const Polynomial& a, const Polynomial& b) {
    if (b.is_zero())
        throw Error(ErrorCode::division_by_zero, "a polynomial cannot be divided by the zero polynomial");
    const auto& divisor = b.coefficients().numerators();
    std::vector<Integer> remainder = a.coefficients().numerators();
    if (remainder.size() < divisor.size()) return {Polynomial(), a};

    const std::size_t steps = remainder.size() - divisor.size() + 1;
    std::vector<Integer> quotient(steps);
    const Integer& leading = divisor.back();
    Integer scale = 1;
    for (std::size_t step = steps; step-- > 0;) {
        const Integer top = remainder.back();
        remainder.pop_back();
        for (Integer& entry : remainder) entry *= leading;
        for (Integer& entry : quotient) entry *= leading;
        for (std::size_t j = 0; j + 1 < divisor.size(); ++j)
            remainder[step + j].add_product(-top, divisor[j]);
        quotient[step] = top;
        scale *= leading;
    }
    // leading^steps * numerators(a) = quotient * numerators(b) + remainder
    const Integer denominator = scale * a.coefficients().denominator();
    for (Integer& entry : quotient) entry *= b.coefficients().denominator();
    return {Polynomial(RationalVector(std::move(quotient), denominator)),
            Polynomial(RationalVector(std::move(remainder), denominator))};
}

Polynomial divide_exactly(const Polynomial& a, const Polynomial& b) {
    auto [quotient, remainder] = divide(a, b);
    if (!remainder.is_zero()) {
        throw Error(ErrorCode::inexact_division, "the divisor of degree " + std::to_string(b.degree()) +
                                                     " does not divide the polynomial of degree " +
                                                     std::to_string(a.degree()));
    }
    return quotient;
}

Polynomial gcd(const Polynomial& a, const Polynomial& b) {
    if (a.is_zero() || b.is_zero()) return monic(a.is_zero() ? b : a);
    return monic(Polynomial(
        RationalVector(primitive_gcd(a.coefficients().numerators(), b.coefficients().numerators()), 1)));
}

Polynomial pow(const Polynomial& base, Count exponent) {
    const std::size_t most = Limits{}.numbers;
    if (base.degree() > 0 && exponent > most / base.degree()) {
        throw limit_error("the degree of a power exceeds", "numbers", most);
    }
    Polynomial result = 1;
    Polynomial square = base;
    for (std::size_t rest = exponent; rest != 0; rest >>= 1) {
        if (rest & 1) result *= square;
        if (rest > 1) square *= square;
    }
    return result;
}

}  // namespace blossom
