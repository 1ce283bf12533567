#pragma once

#include <blossom/proofs/prover.hpp>

#include <span>

#include "elimination.hpp"

namespace blossom::proofs {

/// A place where a claim fails, and all symbols with a value there.
struct Witness {
    Counterexample counterexample;
    std::vector<std::pair<std::string, Rational>> values;
    std::vector<std::string> algebraic;  ///< symbols whose value is a root of a hypothesis
};

/// A counterexample to left == right in one branch of the hypotheses. `steps` are the substitutions on the
/// way there; `difference` is the numerator of left - right after them, not zero; `nonzero` must not vanish.
///
/// Symbol after symbol gets the least of 0, 1, -1, 2, -2, ... that leaves the difference and what must not
/// vanish different from zero, coefficients of maps first, so that maps are sparse and numbers small; symbols
/// with steps follow from these. Both sides are computed anew with these numbers, without expansion. Errors:
/// `internal` if they agree.
Witness find_counterexample(const GroundBlock& block, const Relation& relation, Expander& expander,
                            std::span<const Substitution> steps, const SparsePolynomial& difference,
                            const std::vector<SparsePolynomial>& nonzero);

}  // namespace blossom::proofs
