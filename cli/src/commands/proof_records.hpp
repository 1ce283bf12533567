#pragma once

#include <string>
#include <vector>

#include "proof_task.hpp"
#include "protocol_names.hpp"

namespace blossom::cli {

/// Writes the files that the options name: certificates, lemmas for Coq, LaTeX, JUnit.
/// Errors: std::system_error for a file that cannot be written.
void write_records(const std::vector<ProofText>& texts, std::vector<ProofTask>& tasks,
                   const ProveCommand& command, const Streams& streams);

}  // namespace blossom::cli
