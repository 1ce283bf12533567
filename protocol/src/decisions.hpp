#pragma once

#include <blossom/proofs/prover.hpp>

#include <blossom/protocol/json.hpp>

/// Decisions of the prover for machines.

namespace blossom::protocol {

/// {"verdict", "as_expected", "cases", "terms", "conditions", "title", "statement", "ranges", "by_case",
/// "counterexample"?, "error"?} of one line of a block.
Json to_json(const proofs::Block& block, const proofs::Decision& decision);

}  // namespace blossom::protocol
