#pragma once

#include <cstdint>

namespace blossom {

/// Another line that linear factors are taken over: (constant + slope X) / denominator becomes
///
///     ((b constant - q slope) + (q slope - a constant) X) / (length denominator),
///
/// which is the factor over the control points over [a/q, b/q] for length = b - a. None of the numbers is
/// the least value of 64 bits, and length > 0.
struct WordLine {
    std::int64_t a;
    std::int64_t b;
    std::int64_t q;
    std::int64_t length;
};

}  // namespace blossom
