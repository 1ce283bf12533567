#pragma once

#include <blossom/core/maps/patch_map.hpp>
#include <blossom/rational/limits.hpp>

#include <span>

namespace blossom {

/// The mixed derivative in directions of the whole domain, each a vector with one argument per factor: the
/// sum of the derivatives in directions of single factors.
///
/// Cost: one blossom value for each choice of one factor per direction; equal choices are combined. Errors:
/// `not_affine`, `wrong_arity`, `mismatched_dimensions`; `limit_exceeded` if there are more than
/// `polarization_terms`.
Coordinates directional_derivative(const PatchMap& map, std::span<const PatchPoint> directions,
                                   const PatchPoint& at, const Limits& limits = {});

/// The same as a map, with the least degrees that contain all summands.
template <PatchRepresentation Map>
Map directional_derivative_patch(const Map& patch, std::span<const PatchPoint> directions,
                                 const Limits& limits = {});

}  // namespace blossom
