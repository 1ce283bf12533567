#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "operation.hpp"

/// Maps of a result for a person.

namespace blossom::protocol {

/// A map of a result as a value again. Its rounded twins are left out.
Map result_map(const Json& map, const Limits& limits);

/// The members "map" or "maps" of the result; none if it has neither.
std::vector<Map> maps_of_result(const Answered& answered);

/// The map in one line, "P'(t) = 2 + 8t - 3t^2", or "P': control points over [0, 1]: 2, 6".
std::string line_of(const Json& map, std::string_view name, const Answered& answered);

/// Its points, one a line, each as the blossom value that it is; a polynomial in one line.
std::string listing(const Json& map, const Answered& answered);

/// The same of a map with a control net, under any name.
std::string net_listing(const Json& map, std::string_view name, const Answered& answered);

/// What was asked about, and the listings of the members "map" or "maps" of the result.
std::string described_listing(const Answered& answered);

}  // namespace blossom::protocol
