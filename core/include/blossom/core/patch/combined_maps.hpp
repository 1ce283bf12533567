#pragma once

#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/core/maps/patch_map.hpp>
#include <blossom/core/patch/coordinate_sums.hpp>
#include <blossom/core/patch/tensor_bspline.hpp>
#include <blossom/rational/limits.hpp>

#include <span>

namespace blossom {

/// The map on one domain whose coordinate j is sums[j] of the coordinates of `maps`: sums, products,
/// determinants and whatever is polynomial in the coordinates.
///
/// A product has the sum of the formal degrees of its factors, and the result the greatest degrees of its
/// products, to which the others are raised. Products of control nets are those of the homogeneous
/// polynomials of their points, whose coefficients are the points times multinomial coefficients. Cost: one
/// product of coefficients for each pair, each product of coordinates once; for curves one
/// `product` of integer polynomials. Errors: `mismatched_dimensions` at `Part::maps / i` unless all maps have
/// the same factors; `limit_exceeded`. Source: Farouki and Rajan, Algorithms for polynomials in Bernstein
/// form (1988).
template <PatchRepresentation Map>
Map combined(std::span<const Map> maps, std::span<const CoordinateSum> sums, const Limits& limits = {});

/// The same of curves.
PolynomialCurve combined(std::span<const PolynomialCurve> maps, std::span<const CoordinateSum> sums,
                         const Limits& limits = {});
/// Errors as well: `outside_domain` at `Part::maps / i` unless all are over one interval.
BezierCurve combined(std::span<const BezierCurve> maps, std::span<const CoordinateSum> sums,
                     const Limits& limits = {});

/// The same of B-splines over one box, on each box of the spans of all of them.
///
/// A direction has the knots of all maps. Where map i of degree n_i has a knot m_i times, the result of
/// degree n has it n - min_i (n_i - m_i) times, which keeps the order of contact. In the textbook convention
/// there are n + 1 knots at each end of the domain; knots that are the same for all maps, and for the degree
/// of the result, stay. Cost besides: the pieces of every map, and one blossom value per control point and
/// row of the result; sums over the same knots are those of the control points. Errors as well:
/// `outside_domain` for another box; `limit_exceeded`. Source: Moerken, Some identities for products and
/// degree raising of splines (1991).
TensorBSpline combined(std::span<const TensorBSpline> maps, std::span<const CoordinateSum> sums,
                       const Limits& limits = {});
BSplineCurve combined(std::span<const BSplineCurve> maps, std::span<const CoordinateSum> sums,
                      const Limits& limits = {});

/// `composed` with B-splines as arguments, on each of their pieces; with the knots of `combined`.
template <PatchRepresentation Outer>
TensorBSpline composed(const Outer& outer, const TensorBSpline& arguments, const Limits& limits = {});

}  // namespace blossom
