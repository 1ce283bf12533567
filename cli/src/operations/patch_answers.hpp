#pragma once

#include <vector>

#include "operations/operation.hpp"

/// What the operations answer for maps on products of simplices and in several variables. Each reads the
/// fields of the request besides the map and finishes it.

namespace blossom::cli {

/// The patch of a map, or nullptr for a curve.
inline const Patch* patch_of(const Map& map) { return std::get_if<Patch>(&map.value); }

/// The patch as a control net with its domain, a polynomial over the unit box or simplex.
Patch as_net(const Patch& patch, const Limits& limits);

Json evaluate_patch(Fields& request, const Map& map, const Limits& limits);
Json blossom_of_patch(Fields& request, const Map& map, const Limits& limits);
Json agree_on_patch(Fields& request, const Map& map, const Limits& limits);
/// "direction" and "order", or "directions"; without "at" the derived map.
Json derivative_of_patch(Fields& request, const Map& map, const Limits& limits);
/// "vertices" or "intervals", "degree" or "degrees".
Json control_net_of_patch(Fields& request, const Map& map, const Limits& limits);
/// "at": a point of the simplex or "midpoints"; for a tensor product one number or null a direction.
Json subdivide_patch(Fields& request, const Map& map, const Limits& limits);
/// "by": a number, or one a direction.
Json elevate_patch(Fields& request, const Map& map, const Limits& limits);
/// Of two patches along what their domains share.
Json continuity_of_patches(Fields& request, const std::vector<Map>& maps, const Limits& limits);

/// The blossom of a patch expanded, for a person.
std::string patch_expansion_text(const Answered& answered);

}  // namespace blossom::cli
