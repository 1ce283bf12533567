#pragma once

#include <blossom/rational/limits.hpp>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <blossom/protocol/json.hpp>
#include "json/fields.hpp"
#include "kinds.hpp"
#include "points.hpp"

namespace blossom::protocol {

/// A map as a request gives it. A rational one is a polynomial map into one dimension more: (w x, w), the
/// weight last.
struct Map {
    AnyMap value;
    PointForm form;
    std::string variable = "t";  ///< the name of the parameter in its text
};

/// Another map whose points are written as those of the original.
inline Map like(const Map& original, AnyMap value) {
    return {std::move(value), original.form, original.variable};
}
inline std::vector<Map> like(const Map& original, std::vector<AnyMap> values) {
    std::vector<Map> maps;
    maps.reserve(values.size());
    for (AnyMap& value : values) maps.push_back(like(original, std::move(value)));
    return maps;
}

std::size_t dimension_of(const Map& map);
/// How many coordinates a point of the map has besides its weight.
inline std::size_t point_dimension(const Map& map) { return dimension_of(map) - (map.form.rational ? 1 : 0); }

/// Reads a map of any kind. Errors: `wrong_kind` for an unknown kind; those of the kind.
Map read_map(const Json& value, const Limits& limits);

/// The map in the form of a request.
Json to_json(const Map& map);

/// "P(t) = ..." for a polynomial, the points for other maps.
std::string formula(const Map& map, std::string_view name);

/// `formula` for P with the degree if it does not show it: "P(t) = 1 + 2t, formal degree 1".
std::string description(const Map& map);

}  // namespace blossom::protocol
