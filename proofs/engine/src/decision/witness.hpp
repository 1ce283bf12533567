#pragma once

#include <blossom/proofs/prover.hpp>

#include "elimination.hpp"

namespace blossom::proofs {

/// A counterexample to left == right, where `difference` is the numerator of left - right after elimination,
/// not zero: symbol after symbol gets the least of 0, 1, -1, 2, -2, ... that leaves the difference and all
/// conditions different from zero, coefficients of maps first, so that maps are sparse and numbers small.
///
/// Both sides are computed anew with these numbers, without expansion. Errors: `internal` if they agree.
Counterexample find_counterexample(const GroundBlock& block, const Relation& relation,
                                   SparsePolynomial difference, std::vector<SparsePolynomial> conditions,
                                   const Elimination& elimination);

}  // namespace blossom::proofs
