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

/// Names of a block that nothing declares and that occur once, or resemble a name that is known: each stands
/// for any number, and may be misspelt. None for a strict block, where such a name is an error. Cost: the
/// square of the number of names. Errors: those of the declarations.
std::vector<Warning> doubtful_names(const Block& block);

}  // namespace blossom::proofs
