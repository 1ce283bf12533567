#pragma once

#include <blossom/proofs/expansion.hpp>

#include <optional>
#include <set>
#include <span>
#include <vector>

namespace blossom::proofs {

/// The hypotheses of a case, solved: each gives one symbol as a rational function of those that stay free.
class Elimination {
public:
    Elimination(const GroundBlock& block, Expander& expander) : block_(block), expander_(expander) {}

    /// Takes the hypotheses and assumptions of the block. Errors, with the offset of the line: `syntax` for a
    /// condition that can never hold, and for a hypothesis that is not linear in any symbol.
    void solve();

    /// What remains of a polynomial when the solved symbols are replaced, up to factors that do not vanish.
    SparsePolynomial reduced(SparsePolynomial polynomial);

    /// The factors that must not vanish for this: the conditions of the solutions.
    const std::set<std::size_t>& conditions() const { return conditions_; }

    struct Solution {
        std::size_t symbol{};
        SparsePolynomial numerator;  ///< symbol = numerator / denominator
        SparsePolynomial denominator;
    };
    const std::vector<Solution>& solutions() const { return solutions_; }
    /// The factors of left - right of each `assume`.
    const std::set<std::size_t>& assumed() const { return assumed_; }

private:
    void assume(const Relation& relation);
    void use(const SparsePolynomial& equation, std::size_t offset);

    const GroundBlock& block_;
    Expander& expander_;
    std::vector<Solution> solutions_;
    std::set<std::size_t> conditions_;
    std::set<std::size_t> assumed_;
};

/// The coefficients of a polynomial by powers of one variable, lowest first.
std::vector<SparsePolynomial> coefficients_in(const SparsePolynomial& polynomial, std::size_t variable);

}  // namespace blossom::proofs
