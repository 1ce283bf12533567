#pragma once

#include <blossom/proofs/syntax.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace blossom::proofs {

/// A place that may be a mistake.
struct Warning {
    std::size_t offset = 0;
    std::string message;
};

/// Undeclared names of a block that occur only once or resemble a known name. Such a name denotes an
/// arbitrary number, and may be misspelt. A strict block has none, because there it is an error. Cost: the
/// square of the number of names. Errors: those of the declarations.
std::vector<Warning> doubtful_names(const Block& block);

}  // namespace blossom::proofs
