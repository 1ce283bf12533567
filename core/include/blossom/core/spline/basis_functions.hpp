#pragma once

#include <blossom/core/algebra/polynomial.hpp>
#include <blossom/core/maps/knot_vector.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <vector>

namespace blossom {

/// What a function is on one span.
struct PolynomialPiece {
    std::size_t span = 0;
    Interval interval;
    Polynomial polynomial;

    friend bool operator==(const PolynomialPiece&, const PolynomialPiece&) = default;
};

/// The B-spline basis function N_j within the domain: the scalar curve whose control point j is 1 and all
/// others 0, as one polynomial in t for each non-empty span on which it has influence. It is 0 on all others.
///
/// Cost: at most n + 1 Bezier segments. Errors: `wrong_arity` if there is no point j; `limit_exceeded`.
/// Statements: hart-four-points, hart-three-at-knot.
std::vector<PolynomialPiece> basis_function(const KnotVector& knots, std::size_t point,
                                            const Limits& limits = {});

/// The n + 1 basis functions that are not zero throughout the span of t.
struct BasisValues {
    std::size_t first_point = 0;
    std::vector<Rational> values;  ///< N_(first_point), ..., N_(first_point + n); their sum is 1
};

/// N_j(t): de Boor's algorithm on unit control points. Cost: n^3 / 2 combinations of numbers.
/// Errors: `outside_domain`, `limit_exceeded`.
BasisValues basis_values(const KnotVector& knots, const Rational& t, const Limits& limits = {});

}  // namespace blossom
