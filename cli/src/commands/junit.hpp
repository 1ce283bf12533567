#pragma once

#include <string>
#include <vector>

#include "proof_task.hpp"

namespace blossom::cli {

/// The report of a run in the XML that JUnit has made common: a suite a text, a case a line `claim` or
/// `refute`. What is not as expected is a failure; what was not decided, on what the two roads disagree, and
/// a block that could not be read are errors. Each has the text that `prove` prints.
std::string junit_report(const std::vector<ProofText>& texts, const std::vector<ProofTask>& tasks);

}  // namespace blossom::cli
