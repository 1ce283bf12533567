#pragma once

#include <blossom/core/algebra/polynomial.hpp>
#include <blossom/core/algebra/sparse_polynomial.hpp>

#include <cstddef>

namespace blossom {

/// The determinant of Sylvester's matrix of the actual degrees m and n: 0 if and only if the polynomials have
/// a common root, or one of them is 0; a^n for a constant a. By the remainders of Euclid's algorithm: res(a,
/// b) = (-1)^(m n) lc(b)^(m - deg r) res(b, r). Cost: m n operations on rationals whose length grows with the
/// degrees.
Rational resultant(const Polynomial& a, const Polynomial& b);

/// The resultant with respect to one variable, a polynomial in the others: the determinant of Sylvester's
/// matrix of the degrees m and n in this variable, 0 if one of the polynomials is 0. By elimination without
/// fractions. Cost: (m + n)^3 / 3 products and exact divisions of polynomials. Source: Bareiss, Sylvester's
/// identity and multistep integer-preserving Gaussian elimination, 1968.
SparsePolynomial resultant(const SparsePolynomial& a, const SparsePolynomial& b, std::size_t variable);

}  // namespace blossom
