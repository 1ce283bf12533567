#pragma once

#include <cstdint>

namespace blossom {

/// A change of the line over which linear factors are taken: (constant + slope X) / denominator becomes
///
///     ((b constant - q slope) + (q slope - a constant) X) / (length denominator),
///
/// the factor for control points over [a/q, b/q] with length = b - a. None of the numbers is the least 64-bit
/// value, and length > 0.
struct WordLine {
    std::int64_t a;
    std::int64_t b;
    std::int64_t q;
    std::int64_t length;
};

}  // namespace blossom
