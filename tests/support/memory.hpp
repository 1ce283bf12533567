#pragma once

#include <cstddef>

namespace blossom::testing {

/// The most memory that this process has held so far, in MiB. A refusal that comes before the memory is taken
/// leaves it be.
std::size_t peak_memory();

}  // namespace blossom::testing
