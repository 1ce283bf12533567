#include <blossom/core/sparse_algebra.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <optional>
#include <vector>

namespace blossom {

namespace {

std::vector<std::size_t> exponents(const SparsePolynomial& polynomial, std::size_t term) {
    std::vector<std::size_t> powers(polynomial.variables());
    for (std::size_t i = 0; i < powers.size(); ++i) powers[i] = polynomial.exponent(term, i);
    return powers;
}

/// The quotient of the leading terms, if it is a term.
std::optional<SparsePolynomial> leading_quotient(const SparsePolynomial& a, const SparsePolynomial& b) {
    std::vector<std::size_t> powers = exponents(a, 0);
    for (std::size_t i = 0; i < std::max(a.variables(), b.variables()); ++i) {
        const std::size_t below = b.exponent(0, i);
        if (below > a.exponent(0, i)) return std::nullopt;
        if (i < powers.size()) powers[i] -= below;
    }
    return SparsePolynomial::term(a.coefficient(0) / b.coefficient(0), powers);
}

SparsePolynomial monic(const SparsePolynomial& polynomial) {
    return polynomial.is_zero() ? polynomial
                                : polynomial * SparsePolynomial(Rational(1) / polynomial.coefficient(0));
}

/// Coefficients by powers of one variable, lowest first, none for zero: elements of R[x] with R in the other
/// variables.
using Coefficients = std::vector<SparsePolynomial>;

Coefficients coefficients_in(const SparsePolynomial& polynomial, std::size_t variable) {
    if (polynomial.is_zero()) return {};
    std::vector<std::vector<SparsePolynomial>> terms(polynomial.degree_in(variable) + 1);
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        std::vector<std::size_t> powers = exponents(polynomial, i);
        const std::size_t power = polynomial.exponent(i, variable);
        if (power != 0) powers[variable] = 0;
        terms[power].push_back(SparsePolynomial::term(polynomial.coefficient(i), powers));
    }
    Coefficients coefficients;
    for (const auto& summands : terms) coefficients.push_back(sum(summands));
    return coefficients;
}

SparsePolynomial assembled(const Coefficients& coefficients, std::size_t variable) {
    return polynomial_value(coefficients, SparsePolynomial::variable(variable));
}

SparsePolynomial content(const Coefficients& coefficients) {
    SparsePolynomial common;
    for (const SparsePolynomial& coefficient : coefficients) common = gcd(common, coefficient);
    return common;
}

void divide_by(Coefficients& coefficients, const SparsePolynomial& divisor) {
    for (SparsePolynomial& coefficient : coefficients) coefficient = divide_exactly(coefficient, divisor);
}

/// The remainder of leading(b)^k a by b, without common factors of its coefficients.
Coefficients primitive_remainder(Coefficients a, const Coefficients& b) {
    while (a.size() >= b.size()) {
        const SparsePolynomial top = a.back();
        const std::size_t shift = a.size() - b.size();
        a.pop_back();
        for (SparsePolynomial& coefficient : a) coefficient *= b.back();
        for (std::size_t j = 0; j + 1 < b.size(); ++j) a[shift + j] -= top * b[j];
        while (!a.empty() && a.back().is_zero()) a.pop_back();
    }
    if (!a.empty()) divide_by(a, content(a));
    return a;
}

}  // namespace

SparsePolynomial substitute(const SparsePolynomial& polynomial, std::span<const SparsePolynomial> values) {
    std::vector<SparsePolynomial> terms;
    terms.reserve(polynomial.size());
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        std::vector<std::size_t> kept = exponents(polynomial, i);
        std::fill_n(kept.begin(), std::min(kept.size(), values.size()), std::size_t{0});
        SparsePolynomial term = SparsePolynomial::term(polynomial.coefficient(i), kept);
        for (std::size_t j = 0; j < values.size(); ++j) {
            if (const std::size_t power = polynomial.exponent(i, j); power != 0)
                term *= pow(values[j], power);
        }
        terms.push_back(std::move(term));
    }
    return sum(terms);
}

SparsePolynomial derivative(const SparsePolynomial& polynomial, std::size_t variable) {
    std::vector<SparsePolynomial> terms;
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        const std::size_t power = polynomial.exponent(i, variable);
        if (power == 0) continue;
        std::vector<std::size_t> lowered = exponents(polynomial, i);
        --lowered[variable];
        terms.push_back(SparsePolynomial::term(polynomial.coefficient(i) * Rational(power), lowered));
    }
    return sum(terms);
}

SparsePolynomial divide_exactly(const SparsePolynomial& a, const SparsePolynomial& b) {
    if (b.is_zero())
        throw Error(ErrorCode::division_by_zero, "a polynomial cannot be divided by the zero polynomial");
    std::vector<SparsePolynomial> terms;
    for (SparsePolynomial rest = a; !rest.is_zero();) {
        const auto term = leading_quotient(rest, b);
        if (!term) throw Error(ErrorCode::inexact_division, "the divisor does not divide the polynomial");
        rest -= *term * b;
        terms.push_back(*term);
    }
    return sum(terms);
}

SparsePolynomial gcd(const SparsePolynomial& a, const SparsePolynomial& b) {
    if (a.is_zero() || b.is_zero()) return monic(a + b);
    std::size_t variable = 0;
    while (variable < std::max(a.variables(), b.variables()) &&
           a.degree_in(variable) + b.degree_in(variable) == 0) {
        ++variable;
    }
    if (variable == std::max(a.variables(), b.variables())) return 1;

    Coefficients x = coefficients_in(a, variable);
    Coefficients y = coefficients_in(b, variable);
    const SparsePolynomial content_x = content(x);
    const SparsePolynomial content_y = content(y);
    divide_by(x, content_x);
    divide_by(y, content_y);
    while (!y.empty()) {
        Coefficients rest = primitive_remainder(std::move(x), y);
        x = std::move(y);
        y = std::move(rest);
    }
    return monic(gcd(content_x, content_y) * assembled(x, variable));
}

}  // namespace blossom
