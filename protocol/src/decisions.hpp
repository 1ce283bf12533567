#pragma once

#include <blossom/proofs/prover.hpp>

#include <blossom/protocol/json.hpp>
#include "description/members.hpp"

/// Decisions of the prover for machines.

namespace blossom::protocol {

/// {"verdict", "as_expected", "cases", "terms", "conditions", "title", "statement", "ranges", "by_case",
/// "counterexample"?, "error"?} of one line of a block.
Json to_json(const proofs::Block& block, const proofs::Decision& decision);

/// These members, and "lines", the decisions of several lines.
Members decision_members();

}  // namespace blossom::protocol
