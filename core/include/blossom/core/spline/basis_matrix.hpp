#pragma once

#include <blossom/core/maps/interval.hpp>
#include <blossom/core/maps/knot_vector.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <variant>
#include <vector>

namespace blossom {

/// (t - center)^k, k = 0..degree; the monomials for the centre 0.
struct PowerBasis {
    std::size_t degree = 0;
    Rational center;
};
/// C(n, k) s^k (1 - s)^(n-k), s = (t - a) / (b - a).
struct BernsteinBasis {
    std::size_t degree = 0;
    Interval interval;
};
/// The polynomials of degree n that are 1 at one of n + 1 distinct nodes and 0 at the others.
struct LagrangeBasis {
    std::vector<Rational> nodes;
};
/// (t - x_0) ... (t - x_(k-1)), k = 0..n, for n + 1 nodes, of which the last does not matter.
struct NewtonBasis {
    std::vector<Rational> nodes;
};

/// A basis of polynomials of one degree, or of splines, by their knots.
using Basis = std::variant<PowerBasis, BernsteinBasis, LagrangeBasis, NewtonBasis, KnotVector>;

std::size_t degree_of(const Basis& basis);
/// The number of functions of a basis.
std::size_t function_count(const Basis& basis);

/// The coefficients of the functions of one basis in another: function j of `from` is sum_i M[i][j] times
/// function i of `to`, so that M takes the coefficients of any map in `from` to those in `to`.
///
/// Row i is the functional that belongs to function i of `to`, applied to all functions of `from`, each a
/// value of their blossom p, of the degree n of `to`: C(n, k) p(c^(n-k), delta^k) for powers,
/// p(a^(n-k), b^k) for Bernstein polynomials, p(x_i, ..., x_i) for Lagrange polynomials, p at n consecutive
/// knots for B-splines, taken on a segment where that B-spline is not 0, and for Newton's products the sum of
/// values of `newton_form`. All hold on the domain of `to`. Of a B-spline that is 0 throughout the domain,
/// the segment is the nearest one, as if knots were inserted.
///
/// Cost: O(n^3) operations per polynomial or segment of `from`, and for B-splines one blossom value of n + 1
/// coordinates per row. Errors: where a function of `from` is not in the span of `to`: `degree_too_low` at
/// `Part::to` if its degree is higher; `bad_knots` at a knot of `Part::from` if polynomials are wanted of
/// B-splines that are none, or of `Part::to` if this basis is smoother there; `outside_domain` at `Part::to`
/// if the domain of `from` does not contain that of `to`. `wrong_arity` for nodes that are not distinct;
/// `limit_exceeded`. Source: Goldman, theorem 4; DeRose, section 4.7. Statements: goldman-dual-functional,
/// derose-oslo.
std::vector<std::vector<Rational>> basis_matrix(const Basis& from, const Basis& to,
                                                const Limits& limits = {});

}  // namespace blossom
