#pragma once

#include <blossom/rational/error.hpp>
#include <blossom/rational/rational.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace blossom {

/// Errors: `mismatched_dimensions` unless there is room for `dimension` numbers per place.
inline void require_room(std::size_t places, const char* what, std::size_t dimension, std::size_t results) {
    if (results == places * dimension) return;
    throw Error(ErrorCode::mismatched_dimensions,
                "the values at " + std::to_string(places) + " " + what + " are " +
                    std::to_string(places * dimension) + " numbers, and there are places for " +
                    std::to_string(results),
                Part::results);
}

/// `count` numbers, which write(results) computes.
template <class Write>
std::vector<Rational> written(std::size_t count, const Write& write) {
    std::vector<Rational> results(count);
    write(std::span<Rational>(results));
    return results;
}

}  // namespace blossom
