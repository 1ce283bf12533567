#pragma once

#include <string>
#include <vector>

#include "operations/operation.hpp"

/// The pictures of operations on patches.

namespace blossom::protocol {

bool is_surface(const Map& map);

/// The map of the request and, marked, the values at the parameters "at".
std::string surface_of_values(const Answered& answered);

/// The patches of a result, and the control net of the map of the request where that is a patch too.
std::string surfaces_of_maps(const Answered& answered, const std::vector<Map>& results);

/// The patches of a result alone.
std::string surfaces_of_result(const Answered& answered, const std::vector<Map>& results);

}  // namespace blossom::protocol
