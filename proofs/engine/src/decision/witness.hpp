#pragma once

#include <blossom/proofs/prover.hpp>

#include <span>

#include "elimination.hpp"

namespace blossom::proofs {

/// A point at which a claim fails, and all symbols that have a value there.
struct Witness {
    Counterexample counterexample;
    std::vector<std::pair<std::string, Rational>> values;
    std::vector<std::string> algebraic;  ///< symbols whose value is a root of a hypothesis
};

/// A counterexample to left == right in one branch of the hypotheses. `steps` are the substitutions on the
/// path to the branch; `difference` is the numerator of left - right after them, not zero; `nonzero` must not
/// vanish.
///
/// Each symbol gets the first of 0, 1, -1, 2, -2, ... for which the difference and the conditions do not
/// vanish, coefficients of maps first, so that maps are sparse and numbers small; symbols with steps follow
/// from these. Both sides are computed again with these numbers, without expansion. Errors: `internal` if
/// they agree.
Witness find_counterexample(const GroundBlock& block, const Relation& relation, Expander& expander,
                            std::span<const Substitution> steps, const SparsePolynomial& difference,
                            const std::vector<SparsePolynomial>& nonzero);

}  // namespace blossom::proofs
