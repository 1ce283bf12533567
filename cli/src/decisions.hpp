#pragma once

#include <blossom/proofs/prover.hpp>

#include <string>

#include "json.hpp"
#include "readable.hpp"

/// Decisions of the prover, for machines and for people.

namespace blossom::cli {

/// {"verdict", "cases", "terms", "conditions", "counterexample"}.
Json to_json(const proofs::Decision& decision);

/// "n = 2, a(t) = t (degree 2), t = 0" and both sides, on indented lines, with commands that compute the
/// values.
std::string readable(const proofs::Counterexample& counterexample);

}  // namespace blossom::cli
