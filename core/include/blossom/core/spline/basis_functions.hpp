#pragma once

#include <blossom/core/algebra/polynomial.hpp>
#include <blossom/core/maps/knot_vector.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <vector>

namespace blossom {

/// A function on one span.
struct PolynomialPiece {
    std::size_t span = 0;
    Interval interval;
    Polynomial polynomial;

    friend bool operator==(const PolynomialPiece&, const PolynomialPiece&) = default;
};

/// The B-spline basis function N_j within the domain: the scalar curve whose control point j is 1 and all
/// others 0, as one polynomial in t for each non-empty span on which it is not zero.
///
/// The function is a divided difference of truncated powers, to which each knot contributes one polynomial: a
/// piece is the sum of the contributions of the knots behind it. Cost: at most n + 1 Taylor shifts, and as
/// many sums of polynomials. Errors: `wrong_arity` if there is no point j; `limit_exceeded`. Source: Curry
/// and Schoenberg, "On Polya frequency functions IV", 1966. Statements: hart-four-points, hart-three-at-knot.
std::vector<PolynomialPiece> basis_function(const KnotVector& knots, std::size_t point,
                                            const Limits& limits = {});

/// The n + 1 basis functions that do not vanish on the span of t.
struct BasisValues {
    std::size_t first_point = 0;
    std::vector<Rational> values;  ///< N_(first_point), ..., N_(first_point + n); their sum is 1
};

/// N_j(t) by the recursion of Cox and de Boor. Cost: n^2 / 2 combinations and divisions of numbers. Errors:
/// `outside_domain`, `limit_exceeded`.
BasisValues basis_values(const KnotVector& knots, const Rational& t, const Limits& limits = {});

}  // namespace blossom
