#pragma once

#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/core/maps/on_simplices.hpp>
#include <blossom/core/maps/polynomial_map.hpp>
#include <blossom/core/maps/polynomial_patch.hpp>

#include <concepts>
#include <variant>

namespace blossom {

inline const NetShape& shape_of(const PolynomialPatch& patch) { return patch.shape(); }
inline const NetShape& shape_of(const BezierPatch& patch) { return patch.shape(); }
inline const PointArray& points_of(const PolynomialPatch& patch) { return patch.coefficients(); }
inline const PointArray& points_of(const BezierPatch& patch) { return patch.control_net(); }

/// A polynomial map on a product of affine spaces or of simplices. Arguments of the first are tuples (mass,
/// x_1, ..., x_s), those of the second are barycentric.
using PatchMap = std::variant<PolynomialPatch, BezierPatch>;

/// Either representation of a patch.
template <class Map>
concept PatchRepresentation =
    OnSimplices<Map> && (std::same_as<Map, PolynomialPatch> || std::same_as<Map, BezierPatch>);

static_assert(OnSimplices<PolynomialCurve> && OnSimplices<BezierCurve>);

/// A curve as a patch on one segment: its argument (u, mass) becomes (mass, u), or barycentric coordinates
/// with respect to the ends of its interval.
inline PolynomialPatch as_patch(const PolynomialCurve& curve) {
    return {shape_of(curve), curve.coefficients()};
}
inline BezierPatch as_patch(const BezierCurve& curve) { return {shape_of(curve), curve.control_points()}; }

}  // namespace blossom
