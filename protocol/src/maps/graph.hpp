#pragma once

#include "map.hpp"

namespace blossom::protocol {

/// The map (t, P(t)), with the coordinates of the parameter in front. Errors, at a place in the map:
/// `wrong_kind`; `limit_exceeded`.
Map graph_of(const Map& map, const Limits& limits);

}  // namespace blossom::protocol
