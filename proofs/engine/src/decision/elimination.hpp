#pragma once

#include <blossom/proofs/expansion.hpp>

#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace blossom::proofs {

/// One use of a hypothesis: `relation` is zero, and of degree `degree` in the symbol with a leading
/// coefficient that does not vanish, so that higher powers of the symbol are replaced by lower ones. Of
/// degree 1 it gives the symbol as a rational function of others; of a higher degree its leading coefficient
/// is 1.
struct Substitution {
    std::size_t symbol = 0;
    std::size_t degree = 1;
    SparsePolynomial relation;
};

/// A hypothesis as an equation: the polynomial is zero. It keeps the place of its line.
struct Equation {
    SparsePolynomial polynomial;
    std::size_t offset = 0;
};

/// What is known at a place of the tree of branches.
struct BranchState {
    std::vector<Equation> equations;  ///< still to be used
    std::set<std::size_t> nonzero;    ///< factors that do not vanish, by number
    std::set<std::size_t> zero;       ///< pivots that vanish, by number
    std::set<std::size_t> solved;     ///< symbols that have a linear step
    std::vector<Substitution> monic;  ///< steps of a higher degree, by now
    bool by_split = false;            ///< a pivot was required to vanish: what does not fit stays open
};

/// The hypotheses of a case, solved. Where a pivot may vanish the case falls into two: the pivot is not zero
/// in the first branch, and zero, a further hypothesis, in the second one. Branches are grown as they are
/// walked through.
struct Branch {
    enum class End {
        unknown,     ///< not grown yet
        solved,      ///< every hypothesis is used
        impossible,  ///< no values satisfy what is required here
        split,       ///< `pivot` decides between the two branches
        open,        ///< what is required here does not fit: it is neither linear nor monic in a variable
    };
    std::vector<Substitution> steps;
    End end = End::unknown;
    SparsePolynomial pivot;
    std::vector<Branch> branches;
    BranchState state;  ///< of a branch that is not grown yet
};

/// Solves the hypotheses of a block for one choice of its parameters.
class Elimination {
public:
    /// Takes hypotheses and assumptions. Errors, with the offset of the line: `syntax` for a condition that
    /// can never hold; those of the expansion.
    Elimination(const GroundBlock& block, Expander& expander);

    /// The tree where the factors with these numbers do not vanish; the same one for the same factors.
    Branch& root(const std::set<std::size_t>& nonzero);
    /// Takes a branch to its end, and begins the branches below it. Errors: `syntax` with the offset of a
    /// hypothesis that is neither linear nor monic in a variable; `limit_exceeded` for too many branches.
    void grow(Branch& branch);

    /// The factors of left - right of each `assume`.
    const std::set<std::size_t>& assumed() const { return assumed_; }

    /// What remains of a polynomial after one step, up to factors known not to vanish.
    SparsePolynomial reduced(const SparsePolynomial& polynomial, const Substitution& step);

    /// Polynomials for the symbols that the first steps of a tree replace, as far as these have leading
    /// coefficients that are numbers.
    std::map<std::size_t, SparsePolynomial> replacements(const Branch& root);

    /// Whether the polynomial is zero at all points of a branch where `nonzero` does not vanish: it, or its
    /// product with these, has a power that the steps reduce to zero. Without steps of a higher degree it
    /// must be zero itself.
    bool vanishes(const SparsePolynomial& polynomial, const std::vector<Substitution>& steps,
                  const std::vector<SparsePolynomial>& nonzero);

    /// The factors of a polynomial, by number.
    std::set<std::size_t> factors_of(const SparsePolynomial& polynomial);

private:
    struct Candidate {
        std::size_t equation;
        Substitution step;
        std::vector<std::size_t> doubtful;  ///< the factors of the leading coefficient that may vanish
        std::size_t doubt = 0;              ///< their terms
        std::size_t size = 0;               ///< terms of the leading coefficient
        std::size_t elsewhere = 0;          ///< other equations in which the symbol occurs
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

/// The coefficients of a polynomial by powers of one variable, lowest first.
std::vector<SparsePolynomial> coefficients_in(const SparsePolynomial& polynomial, std::size_t variable);

}  // namespace blossom::proofs
