#pragma once

#include <blossom/proofs/expansion.hpp>

#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace blossom::proofs {

/// One use of a hypothesis: `relation` is zero, and of degree `degree` in the symbol with a leading
/// coefficient that does not vanish, so that higher powers of the symbol can be replaced by lower ones. For
/// degree 1 this gives the symbol as a rational function of others; for a higher degree the leading
/// coefficient is 1.
struct Substitution {
    std::size_t symbol = 0;
    std::size_t degree = 1;
    SparsePolynomial relation;
};

/// A hypothesis as an equation: the polynomial is zero. The place of its line is kept.
struct Equation {
    SparsePolynomial polynomial;
    std::size_t offset = 0;
};

/// The knowledge at a node of the tree of branches.
struct BranchState {
    std::vector<Equation> equations;  ///< still to be used
    std::set<std::size_t> nonzero;    ///< factors that do not vanish, by number
    std::set<std::size_t> zero;       ///< pivots that vanish, by number
    std::set<std::size_t> solved;     ///< symbols that have a linear step
    std::vector<Substitution> monic;  ///< the steps of a higher degree so far
    /// a pivot was required to vanish: a branch that cannot be decided stays open
    bool by_split = false;
};

/// The solved hypotheses of a case. If a pivot may vanish, the case is split: in the first branch the pivot
/// is not zero, in the second it is zero, which is an additional hypothesis. Branches are computed during the
/// walk through the tree.
struct Branch {
    enum class End {
        unknown,     ///< not computed yet
        solved,      ///< every hypothesis is used
        impossible,  ///< no values satisfy the requirements of this branch
        split,       ///< `pivot` decides between the two branches
        open,        ///< undecided: an equation is neither linear nor monic in a variable
    };
    std::vector<Substitution> steps;
    End end = End::unknown;
    SparsePolynomial pivot;
    std::vector<Branch> branches;
    BranchState state;  ///< of a branch that is not computed yet
};

/// Solves the hypotheses of a block for one choice of its parameters.
class Elimination {
public:
    /// Reads the hypotheses and assumptions. Errors, with the offset of the line: `syntax` for a condition
    /// that can never hold; those of the expansion.
    Elimination(const GroundBlock& block, Expander& expander);

    /// The tree under the condition that the factors with these numbers do not vanish; one tree per set of
    /// factors.
    Branch& root(const std::set<std::size_t>& nonzero);
    /// Computes a branch to its end, and creates the branches below it. Errors: `syntax` with the offset of a
    /// hypothesis that is neither linear nor monic in a variable; `limit_exceeded` for too many branches.
    void grow(Branch& branch);

    /// The factors of left - right of each `assume`.
    const std::set<std::size_t>& assumed() const { return assumed_; }

    /// The remainder of a polynomial after one step, up to factors known not to vanish.
    SparsePolynomial reduced(const SparsePolynomial& polynomial, const Substitution& step);

    /// Polynomials for the symbols that the first steps of a tree replace, while the leading coefficients of
    /// these steps are numbers.
    std::map<std::size_t, SparsePolynomial> replacements(const Branch& root);

    /// Whether the polynomial is zero at all points of a branch where `nonzero` does not vanish: the steps
    /// reduce a power of the polynomial, or of its product with `nonzero`, to zero. Without steps of a higher
    /// degree, the polynomial itself must be zero.
    bool vanishes(const SparsePolynomial& polynomial, const std::vector<Substitution>& steps,
                  const std::vector<SparsePolynomial>& nonzero);

    /// The factors of a polynomial, by number.
    std::set<std::size_t> factors_of(const SparsePolynomial& polynomial);

private:
    struct Candidate {
        std::size_t equation;
        Substitution step;
        std::vector<std::size_t> doubtful;  ///< the factors of the leading coefficient that may vanish
        std::size_t doubt = 0;              ///< the number of their terms
        std::size_t size = 0;               ///< terms of the leading coefficient
        std::size_t elsewhere = 0;          ///< the number of other equations in which the symbol occurs
    };

    bool simplify(BranchState& state);
    bool apply(BranchState& state, const Substitution& step);
    void split(Branch& branch, BranchState state, const Candidate& candidate);
    std::optional<Candidate> best_candidate(const BranchState& state);
    std::optional<Candidate> linear_candidate(const BranchState& state, std::size_t equation);
    std::optional<Candidate> monic_candidate(const BranchState& state, std::size_t equation);
    SparsePolynomial without_factors(SparsePolynomial polynomial, const std::set<std::size_t>& factors);
    bool has_coefficients(const SparsePolynomial& polynomial) const;

    const GroundBlock& block_;
    Expander& expander_;
    std::vector<Equation> equations_;
    std::set<std::size_t> assumed_;
    std::map<std::set<std::size_t>, Branch> known_;
    std::size_t branches_ = 0;
};

/// The coefficients of the powers of one variable, lowest first.
std::vector<SparsePolynomial> coefficients_in(const SparsePolynomial& polynomial, std::size_t variable);

}  // namespace blossom::proofs
