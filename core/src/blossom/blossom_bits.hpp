#pragma once

// Bounds on the bits of a blossom value: those of the numbers of the map, of each argument, and of the frame
// once an argument.

#include <blossom/core/blossom/blossom.hpp>

#include "run_construction.hpp"

namespace blossom {

inline std::size_t numerator_bits(const PolynomialMap& map) {
    return greatest_bit_length(numbers_of(map).numbers().numerators());
}

inline std::size_t frame_bits(const PolynomialMap& map) {
    const auto* bezier = std::get_if<BezierCurve>(&map);
    return bezier ? cleared(bezier->interval()).bits() : 0;
}

}  // namespace blossom
