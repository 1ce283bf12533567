#pragma once

#include <blossom/core/algebra/sparse_polynomial.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace blossom {

/// The polynomial with values[i] substituted for variable i, expanded: a composition in all variables at
/// once.
/// Variables beyond the end of `values` remain. Cost: one product per factor of each term, then one balanced
/// sum.
SparsePolynomial substitute(const SparsePolynomial& polynomial, std::span<const SparsePolynomial> values);

/// The partial derivative with respect to one variable.
SparsePolynomial derivative(const SparsePolynomial& polynomial, std::size_t variable);

/// The coefficients of the powers of one variable, lowest first and none for zero; they are polynomials in
/// the other variables.
/// Cost: one pass.
std::vector<SparsePolynomial> coefficients_by_powers(const SparsePolynomial& polynomial,
                                                     std::size_t variable);

/// The result of a division a / b.
struct Division {
    std::optional<SparsePolynomial> quotient;  ///< if b divides a
    std::size_t work = 0;                      ///< term operations
};

/// a / b if b divides a. If not, the first term of the quotient that is impossible shows it: its exponents
/// exceed the bounds from the degrees of a and b, or its coefficient is not an integer although b is
/// primitive. The division gives up beyond `most_work` term operations.
///
/// Cost: for a divisor of two terms, one pass over a and the quotient; for one of k terms, k log(k)
/// operations per term of the quotient. Errors: `division_by_zero`. Source: Monagan and Pearce, Sparse
/// polynomial division using a heap, 2011.
Division divide(const SparsePolynomial& a, const SparsePolynomial& b,
                std::size_t most_work = std::size_t(-1));

/// a / b where b divides a. Errors: `inexact_division` if b does not divide a, `division_by_zero`.
SparsePolynomial divide_exactly(const SparsePolynomial& a, const SparsePolynomial& b);

/// Whether the square of a factor that contains the variable may divide the polynomial. False is certain: an
/// image modulo a prime, with numbers for the other variables, has no such factor. True is wrong only if a
/// discriminant vanishes at these numbers. Cost: one pass, and n^2 multiplications of words for degree n in
/// the variable.
bool may_have_repeated_factor(const SparsePolynomial& polynomial, std::size_t variable);

/// The greatest common divisor, with leading coefficient 1 in lexicographic order; gcd(0, 0) = 0.
/// Computed by primitive remainder sequences, one variable after the other, for polynomials of moderate size.
SparsePolynomial gcd(const SparsePolynomial& a, const SparsePolynomial& b);

}  // namespace blossom
