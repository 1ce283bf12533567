#pragma once

// What the contact of patches and that of rational patches share.

#include <blossom/core/patch/patch_contact.hpp>

#include <vector>

namespace blossom {

/// How many of the vertices, with multiplicities as exponents, are off the face.
std::size_t distance_from(const std::vector<MultiIndex>& indices, const Face& face);

/// Errors: `mismatched_dimensions`, `wrong_arity` unless both patches and the face are of one product of
/// simplices, and the points of one dimension.
void require_comparable(const PlacedPatch& left, const PlacedPatch& right, const Face& face);

/// The control net over other simplices.
BezierPatch over_frames(const PlacedPatch& patch, std::span<const BarycentricFrame> frames,
                        const Limits& limits);

}  // namespace blossom
