#pragma once

#include <blossom/rational/rational.hpp>

#include <optional>
#include <span>
#include <vector>

/// Polynomials with integer coefficients, lowest power first. The last coefficient is not 0; the zero
/// polynomial has none.

namespace blossom {

using IntegerPolynomial = std::vector<Integer>;

/// a * b, of which leading zeros are kept: a.size() + b.size() - 1 coefficients, or none.
///
/// Cost: a.size() * b.size() products of numbers; from 8 coefficients of each on one product of two
/// integers, the values at a power of two (Kronecker's substitution), which have as many bits as the
/// coefficients together.
IntegerPolynomial product(std::span<const Integer> a, std::span<const Integer> b);

/// a / b; none where a quotient with integer coefficients does not exist. `b` is not zero.
/// Cost: O(n m) products for quotient and divisor of the degrees n and m.
std::optional<IntegerPolynomial> exact_quotient(std::span<const Integer> a, std::span<const Integer> b);

/// The greatest common divisor with coprime coefficients and a positive leading one, of polynomials that are
/// not zero.
///
/// It is put together from its residues modulo primes, and proved by dividing both polynomials. Coprime
/// polynomials are known by one prime, with O(n^2) word operations. Source: Brown, "On Euclid's algorithm and
/// the computation of polynomial greatest common divisors", 1971.
IntegerPolynomial primitive_gcd(std::span<const Integer> a, std::span<const Integer> b);

/// All rational roots of a polynomial that is squarefree and not zero, in no order.
///
/// Simple roots modulo a small prime are lifted to its powers; a power beyond twice the product of the first
/// and the last coefficient determines a rational root, which is then tested by a division. Source: Loos,
/// "Computing rational zeros of integral polynomials by p-adic expansion", 1983.
///
/// Cost: O(p n) word operations for primes p near 4000, and O(n) products of numbers of up to h bits for each
/// root modulo p, h the bits of the first and the last coefficient together.
std::vector<Rational> rational_roots(std::span<const Integer> polynomial);

}  // namespace blossom
