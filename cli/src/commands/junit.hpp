#pragma once

#include <string>
#include <vector>

#include "proof_task.hpp"

namespace blossom::cli {

/// The report of a run in the XML format of JUnit: one suite per text, one test case per line `claim` or
/// `refute`. An unexpected verdict is a failure. An undecided line, a disagreement of the two roads and a
/// block that cannot be read are errors. Each has the text that `prove` prints.
std::string junit_report(const std::vector<ProofText>& texts, const std::vector<ProofTask>& tasks);

}  // namespace blossom::cli
