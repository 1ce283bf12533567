#pragma once

#include <blossom/core/blossom/blossom.hpp>

#include <string_view>

namespace blossom {

/// How a curve is approximated by one of lower degree over its interval.
///
/// - `inverse_formula`: the polarization formula with the lower degree. It keeps the ends and uses points of
/// the curve
///   alone; for m >= 3 it interpolates nothing but the ends.
/// - `least_squares`: the least integral of |P - Q|^2, coordinate by coordinate.
/// - `least_squares_endpoints`: the same among the curves with the ends of P.
/// - `uniform`: the least maximum of |P - Q| in each coordinate, by one degree, with a Chebyshev polynomial.
enum class ReductionMethod { inverse_formula, least_squares, least_squares_endpoints, uniform };

/// The protocol's word for a method, for instance "least-squares".
std::string_view reduction_method_name(ReductionMethod method);

struct Reduction {
    BezierCurve curve;
    /// Whether nothing was lost: `curve` is the same map, of lower formal degree.
    bool exact;
    /// The integral of |P - Q|^2 over the interval, summed over the coordinates.
    Rational l2_squared;
    /// For `uniform`, the maximum of |P - Q| over the interval in each coordinate; empty for the others.
    Coordinates maximum;
};

/// `curve` over its interval by a curve of degree m <= n, with the exact error.
///
/// Cost: O(n^2) products of integers, of O(n log n) bits for n - m bounded; the numbers of the inverse
/// formula have O((n - m) m) bits more, as in the result. Errors: `degree_too_low` if m > n, if m < n - 1 for
/// `uniform`, or if m = 0 < n for fixed ends; `limit_exceeded`. Source: Fernandez-Jambrina, section 5 and
/// example 2. Statements: fj-ex2-reduction, fj-reduction-is-lagrange, fj-chebyshev, fj-dual-bernstein,
/// fj-l2-endpoints.
Reduction reduce(const BezierCurve& curve, std::size_t m, ReductionMethod method, const Limits& limits = {});

}  // namespace blossom
