#pragma once

#include <vector>

#include "operations/operation.hpp"
#include "protocol_names.hpp"

namespace blossom::cli {

/// The operations as commands behind `explain`: the same options, which write into the explained request, and
/// those that say how the document is written.
const std::vector<Operation>& explained_operations();

}  // namespace blossom::cli
