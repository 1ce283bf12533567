#pragma once

#include <blossom/core/algebra/polynomial.hpp>
#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/knot_vector.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <span>
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

/// The knots of the B-spline of degree n on its own n + 2 knots, with n more on each side at distance 1: the
/// domain is its support, and it is function n.
///
/// Errors: `wrong_arity` unless there are n + 2; those of `require_knots`.
KnotVector knots_around(std::size_t degree, std::span<const Rational> own);

/// The n + 1 basis functions that are not zero throughout one span, as numbers.
struct BasisValues {
    std::size_t first_point = 0;
    std::vector<Rational> values;  ///< of N_(first_point), ..., N_(first_point + n)

    friend bool operator==(const BasisValues&, const BasisValues&) = default;
};

/// The blossoms of the basis functions on a span at n arguments: the weights of the control points in the
/// blossom of any spline there, f(u_1, ..., u_n) = sum_i values[i] P_(first_point + i).
///
/// De Boor's triangle from its apex to its base, which is the recursion of Cox and de Boor where all
/// arguments are equal. Cost: n^2 / 2 combinations and divisions of numbers. Errors: `outside_domain`;
/// `wrong_arity` unless there are n arguments; `limit_exceeded`. Source: DeRose, figure 10. Statement:
/// derose-fig10.
BasisValues blossom_weights(const KnotVector& knots, std::size_t span, std::span<const Argument> arguments,
                            const Limits& limits = {});

/// N_j(t), whose sum is 1: the weights at n times t, on the span to the right of t, at the end of the domain
/// on the last. Cost, errors: those of `blossom_weights`.
BasisValues basis_values(const KnotVector& knots, const Rational& t, const Limits& limits = {});

/// The derivatives of order k at t on that span: n!/(n-k)! times the weights at n - k times t and k times
/// delta; zero for k > n. Cost, errors: those of `blossom_weights`. Source: Goldman, theorem 9. Statement:
/// goldman-thm9.
BasisValues basis_derivatives(const KnotVector& knots, std::size_t order, const Rational& t,
                              const Limits& limits = {});

}  // namespace blossom
