#pragma once

#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/point_array.hpp>
#include <blossom/rational/integer.hpp>

#include <cstddef>
#include <string_view>
#include <vector>

namespace blossom {

/// A point of a representation as a value of the blossom p of its map: point = multiple * p(arguments).
struct StatedValue {
    std::string_view name;  ///< the name of points of this kind, "control point"
    std::size_t index;      ///< among the points of this kind
    std::vector<Argument> arguments;
    Integer multiple;
    Coordinates point;
};

}  // namespace blossom
