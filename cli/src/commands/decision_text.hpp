#pragma once

#include <blossom/proofs/prover.hpp>

#include <string>

#include "protocol_names.hpp"
#include "text/readable.hpp"

/// Decisions of the prover for people.

namespace blossom::cli {

/// The verdict on one line `claim` or `refute` by cases, called `title`, with conditions in front, and below
/// it the counterexample and what was left open. The error, if there is one, is left to the caller.
std::string readable(const proofs::Block& block, const proofs::Decision& decision, const std::string& title,
                     const Style& style);

}  // namespace blossom::cli
