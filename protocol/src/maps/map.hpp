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
    std::string variable = "t";  ///< what its text called the parameter
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

/// A map of any kind. Errors: `wrong_kind` for a kind that is not known, those of the kind.
Map read_map(const Json& value, const Limits& limits);

/// The map as a request may give it again.
Json to_json(const Map& map);

/// "P(t) = ..." for a polynomial, otherwise its points.
std::string formula(const Map& map, std::string_view name);

/// `formula` for P with what else a reader needs to know: "P(t) = 1 + 2t, formal degree 1".
std::string description(const Map& map);

}  // namespace blossom::protocol
