#pragma once

#include <blossom/core/algebra/polynomial.hpp>

#include <cstddef>

namespace blossom {

/// The polynomial of degree at most m that minimises the integral over [0, 1] of the squared difference from
/// `polynomial` with the weight (s (1 - s))^k: least squares for k = 0.
///
/// Multiples of the orthogonal polynomials of degrees n, ..., m + 1 are subtracted, each of which cancels the
/// leading term. Cost: O(n (n - m)) products of integers for degree n. Source: Rodrigues' formula for the
/// Jacobi polynomials, (s (1 - s))^(-k) / j! times derivative j of (s (1 - s))^(j+k).
Polynomial project(const Polynomial& polynomial, std::size_t m, std::size_t k);

/// The integral of the polynomial over [0, 1].
Rational integral_over_unit_interval(const Polynomial& polynomial);

/// T_n(2 s - 1), the Chebyshev polynomial of the interval [0, 1]; its leading coefficient is 2^(2n-1) for n
/// >= 1. Cost: O(n^2). Statement: fj-chebyshev.
Polynomial chebyshev_on_unit_interval(std::size_t n);

}  // namespace blossom
