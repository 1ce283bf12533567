#pragma once

#include <blossom/proofs/prover.hpp>

#include <optional>
#include <string>

namespace blossom::proofs {

/// What a file of such lemmas begins with.
std::string coq_preamble();

/// A proved case as a lemma of Coq over Q, closed by `field`: coefficients and variables are universally
/// quantified, divisors assumed different from zero, blossoms written out as sums over subsets of their
/// arguments. None for a case with hypotheses or with a map of several variables, and for one longer than
/// `longest` characters.
std::optional<std::string> coq_lemma(const ProvedCase& proved, const std::string& name,
                                     std::size_t longest = 20'000);

}  // namespace blossom::proofs
