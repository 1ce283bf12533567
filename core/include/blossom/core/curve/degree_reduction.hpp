#pragma once

#include <blossom/core/blossom/blossom.hpp>

#include <string_view>

namespace blossom {

/// The ways to approximate a curve by one of lower degree over its interval:
///
/// - `inverse_formula`: the polarization formula of the lower degree. It uses only points of the curve and
/// keeps its ends; for m >= 3 it interpolates only at the ends.
/// - `least_squares`: the least integral of |P - Q|^2, in each coordinate.
/// - `least_squares_endpoints`: the same among the curves with the ends of P.
/// - `uniform`: the least maximum of |P - Q| in each coordinate, by a Chebyshev polynomial; it lowers the
/// degree by one.
enum class ReductionMethod { inverse_formula, least_squares, least_squares_endpoints, uniform };

/// The word of the protocol for a method, for instance "least-squares".
std::string_view reduction_method_name(ReductionMethod method);

struct Reduction {
    BezierCurve curve;
    /// Whether `curve` is the same map, with lower formal degree.
    bool exact;
    /// The integral of |P - Q|^2 over the interval, summed over the coordinates.
    Rational l2_squared;
    /// For `uniform`, the maximum of |P - Q| over the interval in each coordinate; otherwise empty.
    Coordinates maximum;
};

/// An approximation of `curve` over its interval by a curve of degree m <= n, with the exact error.
///
/// Cost: O(n^2) products of integers, of O(n log n) bits for bounded n - m; the numbers of the inverse
/// formula, and those of its result, have O((n - m) m) bits more. Errors: `degree_too_low` if m > n, if m < n
/// - 1 for `uniform`, or if m = 0 < n for fixed ends; `limit_exceeded`. Source: Fernandez-Jambrina, section 5
/// and example 2. Statements: fj-ex2-reduction, fj-reduction-is-lagrange, fj-chebyshev, fj-dual-bernstein,
/// fj-l2-endpoints.
Reduction reduce(const BezierCurve& curve, std::size_t m, ReductionMethod method, const Limits& limits = {});

}  // namespace blossom
