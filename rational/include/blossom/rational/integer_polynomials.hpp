#pragma once

#include <blossom/rational/rational.hpp>

#include <optional>
#include <span>
#include <vector>

/// Polynomials with integer coefficients, lowest power first. The last coefficient is not 0; the zero
/// polynomial has none.

namespace blossom {

using IntegerPolynomial = std::vector<Integer>;

/// a * b with all a.size() + b.size() - 1 coefficients, leading zeros included, or none if a factor has none.
///
/// Cost: a.size() * b.size() products of numbers; if both have 8 coefficients or more, one product of two
/// integers, the values at a power of two (Kronecker's substitution), each as long as the coefficients of one
/// factor together.
IntegerPolynomial product(std::span<const Integer> a, std::span<const Integer> b);

/// a / b, or nullopt if no quotient with integer coefficients exists. `b` is not zero.
/// Cost: O(n m) products for a quotient of degree n and a divisor of degree m.
std::optional<IntegerPolynomial> exact_quotient(std::span<const Integer> a, std::span<const Integer> b);

/// The greatest common divisor of polynomials that are not zero, with coprime coefficients and a positive
/// leading coefficient.
///
/// It is reconstructed from its residues modulo primes and verified by dividing both polynomials. One prime
/// suffices to show that polynomials are coprime, with O(n^2) word operations. Source: Brown, "On Euclid's
/// algorithm and the computation of polynomial greatest common divisors", 1971.
IntegerPolynomial primitive_gcd(std::span<const Integer> a, std::span<const Integer> b);

/// The resultant of f = sum f_k t^k and g = sum g_k t^k, whose coefficients are polynomials in s: a
/// polynomial in s, the determinant of Sylvester's matrix with the rows of f first. The last element of each
/// list is not the zero polynomial; a list without elements is the polynomial 0, and so is the resultant
/// then.
///
/// For each of several primes, the images of f and g are evaluated at d + 1 numbers s, their resultants are
/// computed by Euclid's algorithm and interpolated; the primes suffice for the norm of the determinant,
/// |f|^n |g|^m for the degrees m and n in t, where |f| is the sum of the magnitudes of all coefficients.
/// Source: Collins, "The calculation of multivariate polynomial resultants", 1971.
///
/// Cost: for each of n bits(f) + m bits(g) over 62 primes, d (m n + e (m + n)) + d^2 word operations, with d
/// = n e_f + m e_g for the degrees e in s.
IntegerPolynomial resultant(std::span<const IntegerPolynomial> f, std::span<const IntegerPolynomial> g);

/// All rational roots, in no particular order, of a polynomial that is squarefree and not zero.
///
/// Simple roots modulo a small prime are lifted to its powers. A power beyond twice the product of the first
/// and the last coefficient determines a rational root, which a division then verifies. Source: Loos,
/// "Computing rational zeros of integral polynomials by p-adic expansion", 1983.
///
/// Cost: O(p n) word operations for primes p near 4000, and for each root modulo p O(n) products of numbers
/// of up to h bits, h the bits of the first and the last coefficient together.
std::vector<Rational> rational_roots(std::span<const Integer> polynomial);

}  // namespace blossom
