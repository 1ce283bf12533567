#pragma once

#include "map.hpp"

namespace blossom::protocol {

/// The curve (t, P(t)). Errors, at a place in the map: `wrong_kind`; `limit_exceeded`.
Map graph_of(const Map& map, const Limits& limits);

}  // namespace blossom::protocol
