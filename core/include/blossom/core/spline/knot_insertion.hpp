#pragma once

#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

namespace blossom {

/// The same curve with additional knots, by the Oslo algorithm if there are many per segment, otherwise by
/// Boehm's algorithm; both give the same result. Cost, errors and order of the knots: see below.
BSplineCurve insert_knots(const BSplineCurve& curve, std::span<const Rational> knots,
                          const Limits& limits = {});
inline BSplineCurve insert_knots(const BSplineCurve& curve, std::initializer_list<Rational> knots,
                                 const Limits& limits = {}) {
    return insert_knots(curve, std::span(knots.begin(), knots.size()), limits);
}

/// The same curve with the additional knots `knots[0]`, `knots[1]`, ..., by Boehm's algorithm, one knot after
/// the other.
///
/// For a knot x in span i with control points P_0..P_n, the points between the first and the last are
/// replaced by the first level of de Boor's triangle at x: f(x, t_l, ..., t_(l+n-2)), each of which is a
/// combination of two adjacent old points. The new knots may be given in any order and may repeat. Cost for k
/// knots and m points: n combinations of points per knot in one pass over the points, O(m + k n), each
/// reduced once per coordinate, and a sort. Errors: `outside_domain`; `bad_knots` if a multiplicity would
/// exceed degree + 1; the place is `Part::knots / i`. `limit_exceeded`. Source: DeRose, section 4.7; Hart,
/// "Boehm". Statements: derose-boehm-new, derose-boehm-repeat, hart-knot-insertion.
BSplineCurve insert_knots_boehm(const BSplineCurve& curve, std::span<const Rational> knots,
                                const Limits& limits = {});

/// The same curve with the same additional knots, by the Oslo algorithm: every new control point whose window
/// of n new knots contains an inserted one is the value at this window of the blossom of a segment at the
/// inserted knot.
///
/// Cost for k knots and m points: n^2 / 2 combinations of integers for each of at most k n new points, O(m +
/// k n^3), and one reduction per coordinate; if all knots lie in one segment, there are k + n new points.
/// Errors and order of the knots: as for `insert_knots_boehm`. Source: DeRose, section 4.7. Statement:
/// derose-oslo.
BSplineCurve insert_knots_oslo(const BSplineCurve& curve, std::span<const Rational> knots,
                               const Limits& limits = {});

/// Errors: `bad_knots` if a knot cannot be there so often, more than degree + 1 times; in `Part::times`.
void require_multiplicity(std::size_t multiplicity, std::size_t degree);

/// What must be inserted so that each of `wanted` is a knot at least m times, in the order of `wanted`.
/// Errors: those of `require_multiplicity`; `outside_domain`, in `Part::knots / i`.
std::vector<Rational> missing_knots(const KnotVector& knots, std::span<const Rational> wanted, std::size_t m);

}  // namespace blossom
