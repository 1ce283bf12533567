#pragma once

#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/core/maps/polynomial_curve.hpp>
#include <blossom/core/maps/polynomial_patch.hpp>
#include <blossom/core/patch/patch_contact.hpp>
#include <blossom/core/patch/tensor_bspline.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace blossom {

// A direction of a tensor product as one curve in many dimensions: its control point i has the coordinates of
// all points of the net with index i in this direction, one point after the other. What an operation on
// curves does to this curve it does to every row of the net in the direction, and what it decides, such as
// whether a knot can be removed, holds for all rows together. Cost: that of the operation in the dimension
// of the points times the number of rows.

BSplineCurve curve_along(const TensorBSpline& spline, std::size_t direction);
/// Over the interval of the direction. Errors: `mismatched_dimensions` unless the factor is a segment.
BezierCurve curve_along(const PlacedPatch& patch, std::size_t direction);
PolynomialCurve curve_along(const PolynomialPatch& patch, std::size_t direction);

/// The map with another curve along a direction, of the same dimension as `curve_along`; its degree, its
/// knots and its interval become those of the direction. Errors: `mismatched_dimensions`.
TensorBSpline with_curve_along(const TensorBSpline& spline, std::size_t direction, const BSplineCurve& curve);
PlacedPatch with_curve_along(const PlacedPatch& patch, std::size_t direction, const BezierCurve& curve);
PolynomialPatch with_curve_along(const PolynomialPatch& patch, std::size_t direction,
                                 const PolynomialCurve& curve);

/// The map with change(curve) for its curve along a direction.
template <class Map, class Change>
auto changed_along(const Map& map, std::size_t direction, const Change& change) {
    return with_curve_along(map, direction, change(curve_along(map, direction)));
}

}  // namespace blossom
