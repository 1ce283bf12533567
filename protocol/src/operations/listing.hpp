#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "operation.hpp"

/// Maps of a result for a person.

namespace blossom::protocol {

/// A map of a result, and its JSON, which may have rounded numbers too.
struct ShownMap {
    const Map& map;
    const Json& json;
};
std::vector<ShownMap> shown_maps(const Answered& answered);

/// The map in one line, "P'(t) = 2 + 8t - 3t^2", or "P': control points over [0, 1]: 2, 6".
std::string line_of(const Map& map, std::string_view name, const Style& style);

/// Its points, one per line, each as the blossom value that it is; a polynomial in one line.
std::string listing(const ShownMap& shown, const Style& style);

/// The same for a map with a control net, under any name.
std::string net_listing(const ShownMap& shown, std::string_view name, const Style& style);

/// The description of the given map, and the listings of the maps of the result.
std::string described_listing(const Answered& answered);

}  // namespace blossom::protocol
