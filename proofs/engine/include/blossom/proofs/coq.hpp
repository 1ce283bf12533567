#pragma once

#include <blossom/proofs/prover.hpp>

#include <optional>
#include <string>

namespace blossom::proofs {

/// The first lines of a file of such lemmas.
std::string coq_preamble();

/// A proved case as a lemma of Coq over Q, with a proof by `field`: coefficients and variables are
/// universally quantified, divisors are assumed nonzero, and blossoms are written as sums over subsets of
/// their arguments. nullopt for a case with hypotheses, with a map of several variables, or longer than
/// `longest` characters.
std::optional<std::string> coq_lemma(const ProvedCase& proved, const std::string& name,
                                     std::size_t longest = 20'000);

}  // namespace blossom::proofs
