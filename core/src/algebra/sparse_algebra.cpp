#include <blossom/core/algebra/sparse_algebra.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <utility>
#include <vector>

#include "sparse_arithmetic.hpp"

namespace blossom {

namespace {

std::vector<std::size_t> exponents(const SparsePolynomial& polynomial, std::size_t term) {
    std::vector<std::size_t> powers(polynomial.variables());
    for (std::size_t i = 0; i < powers.size(); ++i) powers[i] = polynomial.exponent(term, i);
    return powers;
}

SparsePolynomial monic(const SparsePolynomial& polynomial) {
    return polynomial.is_zero() ? polynomial
                                : polynomial * SparsePolynomial(Rational(1) / polynomial.coefficient(0));
}

/// The coefficients of the powers of one variable, lowest first, none for zero: elements of R[x], where R is
/// the ring in the other variables.
using Coefficients = std::vector<SparsePolynomial>;

constexpr std::uint64_t prime = 2147483647;
using Residues = std::vector<std::uint64_t>;

std::uint64_t power_of(std::uint64_t base, std::uint64_t exponent) {
    std::uint64_t result = 1;
    base %= prime;
    for (; exponent != 0; exponent >>= 1) {
        if (exponent & 1) result = result * base % prime;
        base = base * base % prime;
    }
    return result;
}

/// The coefficients of the powers of one variable modulo the prime, with numbers substituted for the other
/// variables.
Residues image_in(const SparsePolynomial& polynomial, std::size_t variable) {
    Residues image(polynomial.degree_in(variable) + 1);
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        const Integer residue = polynomial.coefficients().numerators()[i] % Integer(prime);
        std::uint64_t term =
            static_cast<std::uint64_t>(residue.word() + static_cast<std::int64_t>(prime)) % prime;
        for (std::size_t j = 0; j < polynomial.variables(); ++j) {
            const std::size_t exponent = polynomial.exponent(i, j);
            if (j != variable && exponent != 0)
                term = term * power_of(1'000'003 * (j + 1) + j * j, exponent) % prime;
        }
        std::uint64_t& entry = image[polynomial.exponent(i, variable)];
        entry = (entry + term) % prime;
    }
    return image;
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

/// The remainder of leading(b)^k a divided by b, without common factors of its coefficients.
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
    if (variable >= polynomial.variables()) return {};
    // The terms that contain the variable stay in order.
    const SparseLayout layout = SparseArithmetic::layout(polynomial);
    const std::size_t words = layout.words();
    SparseTerms terms;
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        const std::size_t power = polynomial.exponent(i, variable);
        if (power == 0) continue;
        const auto from =
            SparseArithmetic::monomials(polynomial).begin() + static_cast<std::ptrdiff_t>(i * words);
        terms.monomials.insert(terms.monomials.end(), from, from + static_cast<std::ptrdiff_t>(words));
        packed_monomials::set_exponent(std::span(terms.monomials).last(words), variable, layout.bits,
                                       power - 1);
        terms.coefficients.push_back(polynomial.coefficients().numerators()[i] * Integer(power));
    }
    return SparseArithmetic::polynomial(std::move(terms), layout, polynomial.coefficients().denominator());
}

std::vector<SparsePolynomial> coefficients_by_powers(const SparsePolynomial& polynomial,
                                                     std::size_t variable) {
    if (polynomial.is_zero()) return {};
    if (variable >= polynomial.variables()) return {polynomial};
    // The terms with the same power of the variable stay in order without it.
    const SparseLayout layout = SparseArithmetic::layout(polynomial);
    const std::size_t words = layout.words();
    std::vector<SparseTerms> terms(polynomial.degree_in(variable) + 1);
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        SparseTerms& to = terms[polynomial.exponent(i, variable)];
        const auto from =
            SparseArithmetic::monomials(polynomial).begin() + static_cast<std::ptrdiff_t>(i * words);
        to.monomials.insert(to.monomials.end(), from, from + static_cast<std::ptrdiff_t>(words));
        packed_monomials::set_exponent(std::span(to.monomials).last(words), variable, layout.bits, 0);
        to.coefficients.push_back(polynomial.coefficients().numerators()[i]);
    }
    std::vector<SparsePolynomial> coefficients;
    coefficients.reserve(terms.size());
    for (auto& power : terms) {
        coefficients.push_back(
            SparseArithmetic::polynomial(std::move(power), layout, polynomial.coefficients().denominator()));
    }
    return coefficients;
}

bool may_have_repeated_factor(const SparsePolynomial& polynomial, std::size_t variable) {
    Residues image = image_in(polynomial, variable);
    const std::size_t degree = polynomial.degree_in(variable);
    if (degree < 2 || image[degree] == 0) return degree >= 2;
    Residues slope(degree);
    for (std::size_t k = 1; k <= degree; ++k) slope[k - 1] = image[k] * (k % prime) % prime;
    // Euclid's algorithm; leading coefficients come last.
    while (true) {
        while (!slope.empty() && slope.back() == 0) slope.pop_back();
        if (slope.empty()) return image.size() > 1;
        const std::uint64_t inverse = power_of(slope.back(), prime - 2);
        while (image.size() >= slope.size()) {
            const std::uint64_t factor = prime - image.back() * inverse % prime;
            const std::size_t shift = image.size() - slope.size();
            for (std::size_t k = 0; k < slope.size(); ++k)
                image[shift + k] = (image[shift + k] + factor * slope[k]) % prime;
            image.pop_back();
        }
        std::swap(image, slope);
    }
}

SparsePolynomial gcd(const SparsePolynomial& a, const SparsePolynomial& b) {
    if (a.is_zero() || b.is_zero()) return monic(a + b);
    std::size_t variable = 0;
    while (variable < std::max(a.variables(), b.variables()) &&
           a.degree_in(variable) + b.degree_in(variable) == 0) {
        ++variable;
    }
    if (variable == std::max(a.variables(), b.variables())) return 1;

    Coefficients x = coefficients_by_powers(a, variable);
    Coefficients y = coefficients_by_powers(b, variable);
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
