#pragma once

#include <vector>

#include "operations/operation.hpp"
#include "protocol_names.hpp"

namespace blossom::cli {

/// The subcommand of `explain` for an operation that has a chapter: the options of the operation, and those
/// that choose the format of the document.
Operation explained(const Operation& operation);

}  // namespace blossom::cli
