#pragma once

#include <blossom/proofs/prover.hpp>

#include <string>
#include <vector>

/// Degrees and variables of the maps of a counterexample, as text.

namespace blossom::proofs {

bool is_tensor(const WitnessMap& map);

/// "degree 2" or "degrees 2, 1"
std::string degrees_text(const WitnessMap& map);

/// The names that the text of the map uses, in order.
std::vector<std::string> variables_of(const WitnessMap& map);

}  // namespace blossom::proofs
