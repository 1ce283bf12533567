#pragma once

#include <blossom/proofs/ground.hpp>

#include <string>

namespace blossom::proofs {

/// A node in the names of the statement: "w(1/2)", "x_1 - x_2". Texts beyond about 200 characters are
/// shortened with "...".
std::string node_text(const GroundBlock& block, NodeId node);

}  // namespace blossom::proofs
