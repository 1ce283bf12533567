#pragma once

#include <blossom/rational/error.hpp>

#include <cstddef>
#include <string>

namespace blossom {

/// Errors: `mismatched_dimensions` unless there is room for the values at all places, `dimension` numbers
/// each.
inline void require_room(std::size_t places, const char* what, std::size_t dimension, std::size_t results) {
    if (results == places * dimension) return;
    throw Error(ErrorCode::mismatched_dimensions,
                "the values at " + std::to_string(places) + " " + what + " are " +
                    std::to_string(places * dimension) + " numbers, and there are places for " +
                    std::to_string(results),
                Part::results);
}

}  // namespace blossom
