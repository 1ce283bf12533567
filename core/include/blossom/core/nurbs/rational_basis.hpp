#pragma once

#include <blossom/core/spline/basis_functions.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace blossom {

/// The rational basis functions R_j = w_j N_j / sum_i w_i N_i that are not zero throughout one span, as
/// quotients of polynomials.
struct RationalPieces {
    std::size_t span = 0;
    Interval interval;
    std::size_t first_point = 0;
    std::vector<Polynomial> numerators;  ///< of R_(first_point), ..., R_(first_point + n)
    Polynomial denominator;
};

/// Their derivatives of order k on each non-empty span, with numerators and a denominator of degree at most
/// n (k + 1): the quotient rule, see `rational_derivative_map`.
///
/// Cost: that of the basis functions, and k products of polynomials per function and span. Errors:
/// `wrong_arity` unless there is one weight per function; `zero_weight` where the denominator is the
/// polynomial 0; `limit_exceeded`.
std::vector<RationalPieces> rational_basis(const KnotVector& knots, std::span<const Rational> weights,
                                           std::size_t order, const Limits& limits = {});

/// Their derivatives of order k at t, on the span of `basis_values`, by the quotient rule.
/// Cost: k + 1 times that of `basis_derivatives`, and k^2 n / 2 products. Errors: `wrong_arity`;
/// `zero_weight` where the denominator vanishes; `outside_domain`; `limit_exceeded`.
BasisValues rational_basis_derivatives(const KnotVector& knots, std::span<const Rational> weights,
                                       std::size_t order, const Rational& t, const Limits& limits = {});

}  // namespace blossom
