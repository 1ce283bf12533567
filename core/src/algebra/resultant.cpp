#include <blossom/core/algebra/resultant.hpp>
#include <blossom/core/algebra/sparse_algebra.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace blossom {

namespace {

using Matrix = std::vector<std::vector<SparsePolynomial>>;

/// n rows with the coefficients of a and m with those of b, highest first, each one place further.
Matrix sylvester_matrix(const std::vector<SparsePolynomial>& a, const std::vector<SparsePolynomial>& b) {
    const std::size_t m = a.size() - 1;
    const std::size_t n = b.size() - 1;
    Matrix rows(m + n, std::vector<SparsePolynomial>(m + n));
    for (std::size_t i = 0; i < n; ++i)
        std::ranges::copy(a.rbegin(), a.rend(), rows[i].begin() + static_cast<std::ptrdiff_t>(i));
    for (std::size_t i = 0; i < m; ++i)
        std::ranges::copy(b.rbegin(), b.rend(), rows[n + i].begin() + static_cast<std::ptrdiff_t>(i));
    return rows;
}

SparsePolynomial determinant_of(Matrix rows) {
    SparsePolynomial previous = 1;
    bool negative = false;
    for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
        const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(k), rows.end(),
                                        [&](const auto& row) { return !row[k].is_zero(); });
        if (pivot == rows.end()) return {};
        if (pivot != rows.begin() + static_cast<std::ptrdiff_t>(k)) {
            std::swap(*pivot, rows[k]);
            negative = !negative;
        }
        for (std::size_t i = k + 1; i < rows.size(); ++i) {
            for (std::size_t j = k + 1; j < rows.size(); ++j) {
                rows[i][j] = divide_exactly(rows[k][k] * rows[i][j] - rows[i][k] * rows[k][j], previous);
            }
        }
        previous = rows[k][k];
    }
    SparsePolynomial result = rows.empty() ? SparsePolynomial(1) : rows.back().back();
    return negative ? -result : result;
}

Rational power(const Rational& base, std::size_t exponent) {
    return {pow(base.numerator(), exponent), pow(base.denominator(), exponent)};
}

}  // namespace

Rational resultant(const Polynomial& a, const Polynomial& b) {
    Polynomial first = a;
    Polynomial second = b;
    Rational factor = 1;
    while (!first.is_zero() && !second.is_zero() && second.degree() > 0) {
        const std::size_t m = first.degree();
        const std::size_t n = second.degree();
        Polynomial remainder = m < n ? first : divide(first, second).second;
        factor *= power(second.leading_coefficient(), m - std::min(m, remainder.degree()));
        if (m * n % 2 != 0) factor = -factor;
        first = std::exchange(second, std::move(remainder));
    }
    if (first.is_zero() || second.is_zero()) return 0;
    return factor * power(second.leading_coefficient(), first.degree());
}

SparsePolynomial resultant(const SparsePolynomial& a, const SparsePolynomial& b, std::size_t variable) {
    if (a.is_zero() || b.is_zero()) return {};
    return determinant_of(
        sylvester_matrix(coefficients_by_powers(a, variable), coefficients_by_powers(b, variable)));
}

}  // namespace blossom
