#pragma once

#include <blossom/core/algebra/sparse_polynomial.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace blossom {

/// The polynomial with values[i] in place of variable i, expanded: composition in all variables at once.
/// Variables beyond the end of `values` stay. Cost: a product a factor of each term, then one balanced sum.
SparsePolynomial substitute(const SparsePolynomial& polynomial, std::span<const SparsePolynomial> values);

/// The partial derivative by one variable.
SparsePolynomial derivative(const SparsePolynomial& polynomial, std::size_t variable);

/// The coefficients by powers of one variable, lowest first and none for zero: polynomials in the others.
/// Cost: one pass.
std::vector<SparsePolynomial> coefficients_by_powers(const SparsePolynomial& polynomial,
                                                     std::size_t variable);

/// What became of a / b.
struct Division {
    std::optional<SparsePolynomial> quotient;  ///< where b divides a
    std::size_t work = 0;                      ///< term operations
};

/// a / b if b divides a. That it does not is seen at the first term of the quotient that cannot be one:
/// because of its exponents, which the degrees of a and b bound, or because it is not an integer where b is
/// primitive. Gives up beyond `most_work` term operations.
///
/// Cost: for a divisor of two terms one pass over a and the quotient; for one of k terms k log(k) operations
/// a term of the quotient. Errors: `division_by_zero`. Source: Monagan and Pearce, Sparse polynomial division
/// using a heap, 2011.
Division divide(const SparsePolynomial& a, const SparsePolynomial& b,
                std::size_t most_work = std::size_t(-1));

/// a / b where b divides a. Errors: `inexact_division` if it does not, `division_by_zero`.
SparsePolynomial divide_exactly(const SparsePolynomial& a, const SparsePolynomial& b);

/// Whether a factor in which the variable occurs may divide the polynomial twice. False is certain: the image
/// modulo a prime, with numbers for the other variables, has none. True is wrong only where a discriminant
/// happens to vanish there. Cost: one pass, and n^2 multiplications in words for degree n in the variable.
bool may_have_repeated_factor(const SparsePolynomial& polynomial, std::size_t variable);

/// The greatest common divisor, with leading coefficient 1 in lexicographic order; gcd(0, 0) = 0.
/// By primitive remainder sequences, one variable after the other: for polynomials of moderate size.
SparsePolynomial gcd(const SparsePolynomial& a, const SparsePolynomial& b);

}  // namespace blossom
