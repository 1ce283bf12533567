#include <blossom/core/algebra/sparse_algebra.hpp>

#include <algorithm>
#include <tuple>

#include "elimination.hpp"

/// Chooses the next equation to use, and the variable to solve it for.

namespace blossom::proofs {

bool Elimination::has_coefficients(const SparsePolynomial& polynomial) const {
    for (std::size_t i = 0; i < block_.symbols.size(); ++i) {
        if (block_.symbols[i].is_map_value() && polynomial.degree_in(i) > 0) return true;
    }
    return false;
}

std::optional<Elimination::Candidate> Elimination::linear_candidate(const BranchState& state,
                                                                    std::size_t equation) {
    const SparsePolynomial& polynomial = state.equations[equation].polynomial;
    const bool with_maps = has_coefficients(polynomial);
    std::optional<Candidate> best;
    const auto rank = [](const Candidate& c) { return std::tuple(c.doubt, c.size, c.elsewhere); };
    const std::vector<std::size_t> degrees = polynomial.degrees();
    for (std::size_t i = degrees.size(); i-- > 0;) {
        if (degrees[i] != 1 || state.solved.contains(i)) continue;
        const SparsePolynomial cofactor = coefficients_in(polynomial, i)[1];
        // From an equation between values of maps, only a number that stands alone is taken, such as a
        // control point.
        if (with_maps && !block_.symbols[i].is_map_value() && cofactor.total_degree() > 0) continue;
        Candidate candidate{equation, {i, 1, polynomial}, {}};
        bool vanishes = false;
        for (const std::size_t factor : factors_of(cofactor)) {
            vanishes = vanishes || state.zero.contains(factor);
            if (state.nonzero.contains(factor)) continue;
            candidate.doubtful.push_back(factor);
            candidate.doubt += expander_.field().factors()[factor].size();
        }
        if (vanishes) continue;
        candidate.size = cofactor.size();
        for (const Equation& other : state.equations)
            candidate.elsewhere += other.polynomial.degree_in(i) > 0 ? 1U : 0U;
        if (!best || rank(candidate) < rank(*best)) best = std::move(candidate);
    }
    return best;
}

/// An equation in which a power of a variable stands alone, such as w^2 == 1/2 or c^2 + s^2 == 1. Repeated
/// factors are divided out: a polynomial that vanishes on the remaining ones vanishes on all.
std::optional<Elimination::Candidate> Elimination::monic_candidate(const BranchState& state,
                                                                   std::size_t equation) {
    const SparsePolynomial& polynomial = state.equations[equation].polynomial;
    std::optional<Candidate> best;
    for (std::size_t i = block_.symbols.size(); i-- > 0;) {
        const std::size_t degree = polynomial.degree_in(i);
        const bool is_root = std::ranges::find(state.monic, i, &Substitution::symbol) != state.monic.end();
        if (degree < 2 || is_root || state.solved.contains(i) || (best && best->step.degree <= degree))
            continue;
        const SparsePolynomial leading = coefficients_in(polynomial, i)[degree];
        if (leading.total_degree() > 0) continue;
        SparsePolynomial relation = polynomial * SparsePolynomial(Rational(1) / leading.coefficient(0));
        if (may_have_repeated_factor(relation, i)) {
            const SparsePolynomial repeated = gcd(relation, derivative(relation, i));
            if (repeated.degree_in(i) > 0) relation = divide_exactly(relation, repeated);
        }
        const std::size_t simple = relation.degree_in(i);
        best = Candidate{equation, {i, simple, std::move(relation)}, {}, 0, simple};
    }
    return best;
}

/// The best equation and variable to continue with: relations between numbers first, because these may occur
/// in the coefficients of others; then linear ones with a leading coefficient known not to vanish. The search
/// ends at the first one whose leading coefficient is a number.
std::optional<Elimination::Candidate> Elimination::best_candidate(const BranchState& state) {
    std::optional<Candidate> best;
    const auto rank = [](const Candidate& c) {
        return std::tuple(!c.doubtful.empty(), c.step.degree, c.doubt, c.size, c.elsewhere);
    };
    const auto consider = [&](std::optional<Candidate> candidate) {
        if (candidate && (!best || rank(*candidate) < rank(*best))) best = std::move(candidate);
    };
    for (const bool with_maps : {false, true}) {
        for (std::size_t i = 0; i < state.equations.size(); ++i) {
            if (has_coefficients(state.equations[i].polynomial) != with_maps) continue;
            std::optional<Candidate> found = linear_candidate(state, i);
            const bool simple = found && found->doubtful.empty() && found->size == 1;
            if (simple) return found;
            if (!found || !found->doubtful.empty()) consider(monic_candidate(state, i));
            consider(std::move(found));
        }
        if (best && best->doubtful.empty()) return best;
    }
    return best;
}

}  // namespace blossom::proofs
