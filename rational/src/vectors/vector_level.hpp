#pragma once

#include <string_view>

namespace blossom::vectors {

/// The greatest level of vector instructions that may be used: "ifma", or what the environment variable
/// BLOSSOM_VECTOR_LEVEL says.
std::string_view level();

}  // namespace blossom::vectors
