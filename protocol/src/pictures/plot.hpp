#pragma once

#include <string>

#include "operations/operation.hpp"

/// The pictures of operations.

namespace blossom::protocol {

/// The map of the request and, marked, the values at the parameters "at".
std::string plot_of_values(const Answered& answered);

/// The map of the request, faint, and the members "map" or "maps" of the result.
std::string plot_of_maps(const Answered& answered);

/// The maps of the result alone, for results that are other curves than the map of the request.
std::string plot_of_result(const Answered& answered);

}  // namespace blossom::protocol
