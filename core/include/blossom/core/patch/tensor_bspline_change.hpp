#pragma once

#include <blossom/core/patch/patch_contact.hpp>
#include <blossom/core/patch/tensor_bspline.hpp>

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

// Operations on tensor products of B-splines: each applies the operation on curves to every row of control
// points in a direction. Cost and errors: those of the rows.

namespace blossom {

/// The same map with degree n + r in one direction. See `elevate` in spline_elevation.hpp. Statement:
/// derose-tensor-allresults.
TensorBSpline elevate(const TensorBSpline& spline, std::size_t direction, std::size_t r,
                      const Limits& limits = {});

/// The parts of the map before and behind a parameter of one direction. See `split` in spline_split.hpp.
std::pair<TensorBSpline, TensorBSpline> split(const TensorBSpline& spline, std::size_t direction,
                                              const Rational& u, const Limits& limits = {});

/// The map over [a, b] in one direction. See `restricted` in spline_split.hpp.
TensorBSpline restricted(const TensorBSpline& spline, std::size_t direction, const Interval& interval,
                         const Limits& limits = {});

/// The partial derivative of order k = orders[d] in direction d, of degree n - k there, or zero of degree 0.
/// See `derivative_curve` in de_boor.hpp. Errors: `wrong_arity` unless there is one order per direction.
TensorBSpline derivative_spline(const TensorBSpline& spline, std::span<const std::size_t> orders,
                                const Limits& limits = {});

/// The maps with common degrees and knots in all directions but one: the greatest degrees, and knots as often
/// as in any of the maps. Where the knots differ, those at the ends are clamped in the textbook convention.
///
/// Cost: that of raising degrees and inserting knots. Errors: `mismatched_dimensions` for another number of
/// directions, `not_adjacent` for other domains in these directions; the place is `Part::maps / i`.
std::vector<TensorBSpline> with_common_knots(std::vector<TensorBSpline> maps, std::size_t direction,
                                             const Limits& limits = {});

/// A Bezier patch over a box as a tensor product with n + 1 knots at each end. The intervals of the box are
/// increasing or reversed. Errors: `mismatched_dimensions` if the patch is not a tensor product.
TensorBSpline bspline_of(const PlacedPatch& patch, const Limits& limits = {});

/// All combinations of one non-empty span per direction, the last direction fastest: the boxes on which the
/// map is one polynomial. Errors: `limit_exceeded` if the Bezier patches over all of them would have too many
/// numbers.
std::vector<std::vector<std::size_t>> boxes_of(const TensorBSpline& spline, const Limits& limits = {});

/// `bezier_segment` with its box.
PlacedPatch placed_segment(const TensorBSpline& spline, std::span<const std::size_t> spans,
                           const Limits& limits = {});

}  // namespace blossom
