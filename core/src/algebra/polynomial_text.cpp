#include <blossom/core/algebra/polynomial_text.hpp>

#include <algorithm>
#include <numeric>

namespace blossom {

namespace {

std::string monomial_text(const SparsePolynomial& polynomial, std::size_t term,
                          std::span<const std::string> names) {
    std::string text;
    for (std::size_t i = 0; i < std::min(polynomial.variables(), names.size()); ++i) {
        const std::size_t power = polynomial.exponent(term, i);
        if (power == 0) continue;
        if (!text.empty()) text += '*';
        text += names[i];
        if (power > 1) text += '^' + std::to_string(power);
    }
    return text;
}

/// "3t", but "3 t1" and "2/3 t": a space separates the coefficient and the name if they would be hard to
/// distinguish.
std::string term_text(const Rational& magnitude, const std::string& monomial) {
    if (monomial.empty()) return to_string(magnitude);
    if (magnitude == Rational(1)) return monomial;
    const bool single_letter = monomial.size() == 1 || monomial[1] == '^' || monomial[1] == '*';
    return to_string(magnitude) + (magnitude.is_integer() && single_letter ? "" : " ") + monomial;
}

}  // namespace

std::string to_text(const SparsePolynomial& polynomial, std::span<const std::string> names) {
    if (polynomial.is_zero()) return "0";
    std::vector<std::size_t> order(polynomial.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t term) { return polynomial.degree(term); });

    std::string text;
    for (const std::size_t term : order) {
        const Rational coefficient = polynomial.coefficient(term);
        const bool negative = coefficient.sign() < 0;
        if (text.empty()) {
            if (negative) text += '-';
        } else {
            text += negative ? " - " : " + ";
        }
        text += term_text(abs(coefficient), monomial_text(polynomial, term, names));
    }
    return text;
}

std::string to_text(const Polynomial& polynomial, std::string_view name) {
    const std::string names[] = {std::string(name)};
    return to_text(sparse(polynomial), names);
}

Polynomial dense(const SparsePolynomial& polynomial) {
    std::vector<Integer> numerators(polynomial.degree_in(0) + 1);
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        numerators[polynomial.exponent(i, 0)] = polynomial.coefficients().numerators()[i];
    }
    return Polynomial(RationalVector(std::move(numerators), polynomial.coefficients().denominator()));
}

SparsePolynomial sparse(const Polynomial& polynomial) {
    std::vector<SparsePolynomial> terms;
    for (std::size_t k = 0; k <= polynomial.degree(); ++k) {
        const std::size_t exponents[] = {k};
        terms.push_back(SparsePolynomial::term(polynomial[k], exponents));
    }
    return sum(terms);
}

std::vector<std::string> numbered_names(std::string_view letter, std::size_t n) {
    std::vector<std::string> names;
    names.reserve(n);
    for (std::size_t i = 1; i <= n; ++i) names.push_back(std::string(letter) + std::to_string(i));
    return names;
}

std::string to_string(const Polynomial& polynomial) { return to_text(polynomial); }

std::string to_string(const SparsePolynomial& polynomial) {
    return to_text(polynomial, numbered_names("x", polynomial.variables()));
}

}  // namespace blossom
