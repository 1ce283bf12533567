#pragma once

#include <blossom/proofs/prover.hpp>

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "elimination.hpp"
#include "witness.hpp"

namespace blossom::proofs {

/// The result of the first road for one claim and one choice of the parameters.
struct CaseOutcome {
    Fraction left;
    std::vector<SparsePolynomial> conditions;  ///< what must not vanish, including pivots that were left open
    Branch root;                               ///< how the claim was decided, branch by branch
    std::vector<Substitution> steps;           ///< on the path to a branch where the claim holds, or fails
    std::optional<Witness> witness;            ///< where the claim fails
};

/// The first road: expands and decides the claims of a block for one choice of its parameters.
class BlockCase {
public:
    BlockCase(const GroundBlock& block, const Limits& limits)
        : block_(block), expander_(block, limits), elimination_(block, expander_) {}

    /// Decides a claim; the conditions, open pivots and terms are stored in `decision`. Errors: `syntax` with
    /// an offset if the hypotheses leave no case; those of the expansion.
    CaseOutcome decide(const Relation& relation, CaseDecision& decision);

    Expander& expander() { return expander_; }

private:
    /// Expands with the polynomials that the first hypotheses give for symbols, so that pyramids stay as
    /// small as without hypotheses.
    Expander& expander_below(const Branch& root);

    struct Walk;

    Branch walk(Branch& branch, Walk& way);
    Branch walk_below(Branch& branch, Walk& way);
    Branch walk_split(Branch& branch, Walk& way);
    static Branch open_branch();
    bool reach_solution(Branch& split, std::vector<Substitution>& steps);
    void end_of_branch(Walk& way);
    void leave_open(const SparsePolynomial& pivot, Walk& way);
    std::set<std::size_t> add_conditions(const Relation& relation, CaseDecision& decision);
    bool has_coefficients(std::size_t factor);
    NodeId base_of(NodeId node) const;
    std::optional<std::size_t> place_of_divisor(NodeId divisor) const;
    std::string condition_text(const SparsePolynomial& factor, std::string_view sign) const;
    std::vector<std::string> names() const;

    const GroundBlock& block_;
    Expander expander_;
    Elimination elimination_;
    std::map<const Branch*, Expander> expanders_;
};

}  // namespace blossom::proofs
