#pragma once

#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <span>
#include <vector>

namespace blossom {

/// Bezier curves on adjacent intervals as one B-spline with the least knot multiplicities, in the textbook
/// convention with n + 1 knots at each end. n is the greatest degree of the curves, to which the others are
/// raised.
///
/// The knot between two curves that meet with order k gets multiplicity n - k; there is none if both are the
/// same polynomial. Control point j is the blossom value, at its window of n knots, of any curve on which it
/// has influence. The intervals increase from curve to curve; each may be given reversed. A single curve
/// becomes a spline of one segment. Cost for m curves: O(m n) blossom values, and O(m n^2) for raising the
/// degrees. Errors: `wrong_arity` for no curve; `not_adjacent`, `mismatched_dimensions`, with places below
/// `Part::maps / i`; `limit_exceeded`. Source: DeRose, theorem 2 and section 4.6. Statement: derose-thm2.
BSplineCurve join(std::span<const BezierCurve> curves, const Limits& limits = {});

/// The same over given knots of degree n, at least the greatest degree of the curves. `knots` may contain
/// additional knots and higher multiplicities than the least.
///
/// Additional errors: `bad_knots` if the intervals do not make up the domain of the knots; `not_continuous`,
/// naming the knot and the blossom values that differ, if two curves meet with an order below n -
/// multiplicity; `degree_too_low` if n is below the degree of a curve.
BSplineCurve join(std::span<const BezierCurve> curves, const KnotVector& knots, const Limits& limits = {});

/// The same of curves in pieces, such as Bezier curves alone and the segments of splines: `maps[i]` are the
/// pieces of curve i over adjacent intervals.
BSplineCurve join(std::span<const std::vector<BezierCurve>> maps, const Limits& limits = {});
BSplineCurve join(std::span<const std::vector<BezierCurve>> maps, const KnotVector& knots,
                  const Limits& limits = {});
/// The same of curves side by side, `rows` of them with their coordinates one after the other, see
/// curve_along.hpp; the reason of an error is that of the first row that is not continuous enough.
BSplineCurve join_rows(std::span<const std::vector<BezierCurve>> maps, std::size_t rows,
                       const KnotVector& knots, const Limits& limits = {});

/// The interval of curves over adjacent intervals, in increasing direction.
Interval covered(std::span<const BezierCurve> pieces);

/// The curves over intervals as long as their own that follow each other: each begins where the last ends.
std::vector<std::vector<BezierCurve>> chained(std::vector<std::vector<BezierCurve>> maps);

/// Knots of degree n for a given domain, when nothing is said of the number of control points: in the
/// textbook convention if that gives the domain, otherwise in the polar one. Errors: `bad_knots` if neither
/// does.
KnotVector knots_over(std::size_t degree, std::vector<Rational> knots, const Interval& domain);

}  // namespace blossom
