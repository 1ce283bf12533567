#include <blossom/core/curve/orthogonal_projection.hpp>
#include <blossom/rational/combinatorics.hpp>

#include <vector>

namespace blossom {

namespace {

/// The integral of s^i (s (1 - s))^k over [0, 1]: the beta value (i + k)! k! / (i + 2k + 1)!.
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

}  // namespace

// The monic orthogonal polynomials satisfy Q_{j+1} = (s - 1/2) Q_j - (|Q_j|^2 / |Q_{j-1}|^2) Q_{j-1}.
Polynomial project(const Polynomial& polynomial, std::size_t m, std::size_t k) {
    if (polynomial.degree() <= m) return polynomial;
    const RationalVector weights(moments(polynomial.degree() + m + 1, k));
    const Polynomial step = Polynomial::monomial(1) - Polynomial(Rational(1, 2));
    Polynomial previous;
    Polynomial current = 1;
    Rational previous_norm = 1;
    Polynomial projection;
    for (std::size_t j = 0; j <= m; ++j) {
        const Rational norm = inner_product(current, current, weights);
        projection += Polynomial(inner_product(polynomial, current, weights) / norm) * current;
        Polynomial next = step * current - Polynomial(norm / previous_norm) * previous;
        previous = std::move(current);
        current = std::move(next);
        previous_norm = norm;
    }
    return projection;
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
