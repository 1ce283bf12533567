#pragma once

#include <vector>

#include "operations/operation.hpp"
#include "protocol_names.hpp"

namespace blossom::cli {

/// The command behind `explain` for an operation that has a chapter: its options, which write the request
/// that is explained, and those of documents.
Operation explained(const Operation& operation);

}  // namespace blossom::cli
