#pragma once

#include <blossom/proofs/prover.hpp>

#include <string>
#include <vector>

/// Groups of the cases of a decision, for display.

namespace blossom::proofs {

using Cases = std::vector<const CaseDecision*>;

/// The cases with this verdict, in order.
Cases cases_with(const Decision& decision, Verdict verdict);

/// Proved cases with the same conditions.
struct CaseGroup {
    std::vector<std::string> needed;  ///< "a != b": what must not vanish beyond the assumptions of the block
    Cases cases;
};
std::vector<CaseGroup> groups_by_condition(const Decision& decision);

/// The consecutive values first, ..., last of the only parameter of some cases.
struct Run {
    long long first;
    long long last;

    friend bool operator==(const Run&, const Run&) = default;
};
std::vector<Run> runs_of(const Cases& cases);

/// The ranges of the parameters of a line: those of its block, then its own.
std::vector<Range> ranges_of(const Block& block, const Statement& line);

}  // namespace blossom::proofs
