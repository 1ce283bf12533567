#pragma once

#include <cstdint>

namespace blossom {

/// Eight linear factors (constant + slope X) / denominator side by side, in machine words none of which is
/// the least value of 64 bits; denominators are positive.
struct alignas(64) WordFactorOctet {
    std::int64_t constants[8];
    std::int64_t slopes[8];
    std::int64_t denominators[8];
};

}  // namespace blossom
