#pragma once

#include <vector>

#include "maps/parameters.hpp"

namespace blossom::protocol {

/// The values at the parameters, in the coordinates of the engine; the map is prepared if there are many.
/// Errors: `wrong_kind`; `limit_exceeded` for too many; those of the values, below the field "at".
std::vector<Coordinates> values_at(const Map& map, const Parameters& parameters, const Limits& limits);

}  // namespace blossom::protocol
