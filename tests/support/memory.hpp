#pragma once

#include <cstddef>

namespace blossom::testing {

/// The peak memory of this process in MiB. A refusal before memory is allocated leaves it unchanged.
std::size_t peak_memory();

}  // namespace blossom::testing
