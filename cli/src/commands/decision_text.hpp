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

/// "n = 2, a(t) = t (degree 2), t = 0" and both sides, on indented lines, with commands that compute the
/// values.
std::string readable(const proofs::Counterexample& counterexample);

/// "n = 0..6", "d = 1, 3", "(n, k) = (1, 0), (2, 1)": the parameters of the cases with this verdict; for all
/// of several parameters their ranges. Empty without parameters.
std::string cases_text(const proofs::Block& block, const proofs::Decision& decision, proofs::Verdict verdict);

}  // namespace blossom::cli
