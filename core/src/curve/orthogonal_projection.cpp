#include <blossom/core/curve/orthogonal_projection.hpp>
#include <blossom/rational/combinatorics.hpp>

#include <vector>

namespace blossom {

namespace {

/// The integrals of s^i (s (1 - s))^k over [0, 1], which are the beta values (i + k)! k! / (i + 2k + 1)!.
std::vector<Rational> moments(std::size_t count, std::size_t k) {
    std::vector<Rational> values;
    values.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        values.emplace_back(factorial(k), falling_factorial(i + 2 * k + 1, k + 1));
    }
    return values;
}

Rational inner_product(const Polynomial& a, const Polynomial& b, const RationalVector& moments) {
    const Polynomial product = a * b;
    const auto& coefficients = product.coefficients();
    return {dot(coefficients.numerators(), std::span(moments.numerators()).first(coefficients.size())),
            coefficients.denominator() * moments.denominator()};
}

/// The coefficients (-1)^i C(j + k, j - i) C(j + 2k + i, i) of s^i in the orthogonal polynomial of degree j
/// for the weight (s (1 - s))^k.
std::vector<Integer> orthogonal_polynomial(std::size_t j, std::size_t k) {
    std::vector<Integer> coefficients{binomial(j + k, j)};
    for (std::size_t i = 0; i < j; ++i) {
        const Integer product = coefficients.back() * Integer(j - i) * Integer(j + 2 * k + i + 1);
        coefficients.push_back(-divide_exactly(product, Integer(i + 1) * Integer(k + i + 1)));
    }
    return coefficients;
}

}  // namespace

// The nearest polynomial of degree j - 1 is also the nearest one to that of degree j.
Polynomial project(const Polynomial& polynomial, std::size_t m, std::size_t k) {
    if (polynomial.degree() <= m) return polynomial;
    std::vector<Integer> row = polynomial.coefficients().numerators();
    Integer denominator = polynomial.coefficients().denominator();
    for (std::size_t j = polynomial.degree(); j > m; --j) {
        const std::vector<Integer> orthogonal = orthogonal_polynomial(j, k);
        const Integer common = gcd(row[j], orthogonal[j]);
        const Integer scale = divide_exactly(orthogonal[j], common);
        const Integer multiple = -divide_exactly(row[j], common);
        row.pop_back();
        for (std::size_t i = 0; i < j; ++i) {
            row[i] *= scale;
            row[i].add_product(multiple, orthogonal[i]);
        }
        denominator *= scale;
    }
    return Polynomial(RationalVector(std::move(row), std::move(denominator)));
}

Rational integral_over_unit_interval(const Polynomial& polynomial) {
    if (polynomial.is_zero()) return {};
    return inner_product(polynomial, 1, RationalVector(moments(polynomial.degree() + 1, 0)));
}

Polynomial chebyshev_on_unit_interval(std::size_t n) {
    const Polynomial x = Polynomial(2) * Polynomial::monomial(1) - 1;
    Polynomial previous = 1;
    Polynomial current = x;
    for (std::size_t j = 0; j < n; ++j) {
        Polynomial next = Polynomial(2) * x * current - previous;
        previous = std::move(current);
        current = std::move(next);
    }
    return previous;
}

}  // namespace blossom
