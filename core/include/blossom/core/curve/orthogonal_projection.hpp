#pragma once

#include <blossom/core/algebra/polynomial.hpp>

#include <cstddef>

namespace blossom {

/// The polynomial of degree at most m that is nearest to `polynomial` in the integral of its square over [0,
/// 1] with the weight (s (1 - s))^k: least squares for k = 0.
///
/// By the three-term recurrence of the polynomials that are orthogonal for this weight, which are symmetric
/// about 1/2. Cost: O(n^2) operations on rationals for degree n. Source: the Jacobi polynomials on [0, 1].
Polynomial project(const Polynomial& polynomial, std::size_t m, std::size_t k);

/// The integral of polynomial over [0, 1].
Rational integral_over_unit_interval(const Polynomial& polynomial);

/// T_n(2 s - 1), the Chebyshev polynomial of the interval [0, 1], with leading coefficient 2^(2n-1) for n
/// >= 1. Cost: O(n^2). Statement: fj-chebyshev.
Polynomial chebyshev_on_unit_interval(std::size_t n);

}  // namespace blossom
