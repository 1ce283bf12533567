#pragma once

#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/point_array.hpp>
#include <blossom/rational/integer.hpp>

#include <cstddef>
#include <string_view>
#include <vector>

namespace blossom {

/// What a representation of a map says by one of its points: point = multiple * p(arguments), p the blossom.
struct StatedValue {
    std::string_view name;  ///< what points of its kind are called, "control point"
    std::size_t index;      ///< among those
    std::vector<Argument> arguments;
    Integer multiple;
    Coordinates point;
};

}  // namespace blossom
