#pragma once

#include <blossom/core/sparse_polynomial.hpp>

#include <cstddef>
#include <span>

namespace blossom {

/// The polynomial with values[i] in place of variable i, expanded: composition in all variables at once.
/// Variables beyond the end of `values` stay. Cost: a product a factor of each term, then one balanced sum.
SparsePolynomial substitute(const SparsePolynomial& polynomial, std::span<const SparsePolynomial> values);

/// The partial derivative by one variable.
SparsePolynomial derivative(const SparsePolynomial& polynomial, std::size_t variable);

/// a / b where b divides a. Cost: one product of b with a term, and one merge, a term of the quotient.
/// Errors: `inexact_division` if it does not, `division_by_zero`.
SparsePolynomial divide_exactly(const SparsePolynomial& a, const SparsePolynomial& b);

/// The greatest common divisor, with leading coefficient 1 in lexicographic order; gcd(0, 0) = 0.
/// By primitive remainder sequences, one variable after the other: for polynomials of moderate size.
SparsePolynomial gcd(const SparsePolynomial& a, const SparsePolynomial& b);

}  // namespace blossom
