#include "elimination.hpp"

#include <blossom/rational/error.hpp>

#include <algorithm>
#include <map>

namespace blossom::proofs {

namespace {

constexpr std::size_t most_branches = 512;

std::vector<std::size_t> exponents_of(const SparsePolynomial& polynomial, std::size_t term) {
    std::vector<std::size_t> exponents(polynomial.variables());
    for (std::size_t i = 0; i < exponents.size(); ++i) exponents[i] = polynomial.exponent(term, i);
    return exponents;
}

/// The coefficients of the monomials in `variables`, which are universally quantified.
std::vector<SparsePolynomial> coefficients_by_monomials(const SparsePolynomial& polynomial,
                                                        const std::vector<std::size_t>& variables) {
    std::map<std::vector<std::size_t>, std::vector<SparsePolynomial>> terms;
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        std::vector<std::size_t> exponents = exponents_of(polynomial, i);
        std::vector<std::size_t> key;
        for (const std::size_t variable : variables) {
            key.push_back(polynomial.exponent(i, variable));
            if (variable < exponents.size()) exponents[variable] = 0;
        }
        terms[key].push_back(SparsePolynomial::term(polynomial.coefficient(i), exponents));
    }
    std::vector<SparsePolynomial> result;
    result.reserve(terms.size());
    for (const auto& [key, summands] : terms) result.push_back(sum(summands));
    return result;
}

SparsePolynomial power_of(std::size_t variable, std::size_t exponent) {
    return pow(SparsePolynomial::variable(variable), exponent);
}

}  // namespace

std::vector<SparsePolynomial> coefficients_in(const SparsePolynomial& polynomial, std::size_t variable) {
    std::vector<std::vector<SparsePolynomial>> terms(polynomial.degree_in(variable) + 1);
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        std::vector<std::size_t> exponents = exponents_of(polynomial, i);
        const std::size_t power = polynomial.exponent(i, variable);
        if (variable < exponents.size()) exponents[variable] = 0;
        terms[power].push_back(SparsePolynomial::term(polynomial.coefficient(i), exponents));
    }
    std::vector<SparsePolynomial> result;
    result.reserve(terms.size());
    for (const auto& summands : terms) result.push_back(sum(summands));
    return result;
}

Elimination::Elimination(const GroundBlock& block, Expander& expander) : block_(block), expander_(expander) {
    for (const Relation& assumption : block_.assumptions) {
        const Fraction difference =
            expander_.field().difference(expander_(assumption.left), expander_(assumption.right));
        if (difference.is_zero()) {
            throw Error(ErrorCode::syntax, "this condition can never hold: the two sides are equal", {},
                        assumption.offset);
        }
        assumed_.merge(factors_of(difference.numerator));
    }
    for (const Relation& hypothesis : block_.hypotheses) {
        const Fraction difference =
            expander_.field().difference(expander_(hypothesis.left), expander_(hypothesis.right));
        for (SparsePolynomial& equation :
             coefficients_by_monomials(difference.numerator, hypothesis.quantified))
            equations_.push_back({std::move(equation), hypothesis.offset});
    }
}

std::set<std::size_t> Elimination::factors_of(const SparsePolynomial& polynomial) {
    std::set<std::size_t> result;
    for (const auto& [factor, exponent] : expander_.field().factorise(polynomial).factors)
        result.insert(factor);
    return result;
}

Branch& Elimination::root(const std::set<std::size_t>& nonzero) {
    const auto [entry, fresh] = known_.try_emplace(nonzero);
    if (fresh) {
        entry->second.state.equations = equations_;
        entry->second.state.nonzero = nonzero;
    }
    return entry->second;
}

SparsePolynomial Elimination::without_factors(SparsePolynomial polynomial,
                                              const std::set<std::size_t>& factors) {
    if (polynomial.is_zero() || factors.empty() || polynomial.total_degree() == 0) return polynomial;
    return expander_.field().stripped(std::move(polynomial), factors);
}

/// The pseudo-remainder: while the degree in the symbol is too high, the highest power is replaced according
/// to the relation, and the polynomial is multiplied by the leading coefficient of the relation.
SparsePolynomial Elimination::reduced(const SparsePolynomial& polynomial, const Substitution& step) {
    if (polynomial.degree_in(step.symbol) < step.degree) return polynomial;
    FractionField& field = expander_.field();
    const std::vector<SparsePolynomial> relation = coefficients_in(step.relation, step.symbol);
    const SparsePolynomial& leading = relation[step.degree];
    std::vector<SparsePolynomial> powers = coefficients_in(polynomial, step.symbol);
    while (powers.size() > step.degree) {
        const SparsePolynomial highest = std::move(powers.back());
        powers.pop_back();
        if (highest.is_zero()) continue;
        const std::size_t shift = powers.size() - step.degree;
        for (std::size_t k = 0; k < powers.size(); ++k) {
            powers[k] = field.product(powers[k], leading);
            if (k >= shift) powers[k] -= field.product(highest, relation[k - shift]);
        }
    }
    std::vector<SparsePolynomial> summands;
    summands.reserve(powers.size());
    for (std::size_t k = 0; k < powers.size(); ++k) summands.push_back(powers[k] * power_of(step.symbol, k));
    return without_factors(sum(summands), factors_of(leading));
}

bool Elimination::vanishes(const SparsePolynomial& polynomial, const std::vector<Substitution>& steps,
                           const std::vector<SparsePolynomial>& nonzero) {
    std::vector<Substitution> monic;
    std::size_t degree = 1;
    for (const Substitution& step : steps) {
        if (step.degree < 2) continue;
        monic.push_back(step);
        degree *= step.degree;
    }
    if (polynomial.is_zero() || monic.empty()) return polynomial.is_zero();
    const auto remainder = [&](SparsePolynomial product) {
        for (const Substitution& step : steps) product = reduced(product, step);
        return product;
    };
    SparsePolynomial product = polynomial;
    for (const SparsePolynomial& factor : nonzero) {
        const bool concerned = std::ranges::any_of(
            monic, [&](const Substitution& step) { return factor.degree_in(step.symbol) > 0; });
        if (concerned) product = remainder(expander_.field().product(product, factor));
    }
    SparsePolynomial power = product;
    for (std::size_t k = 1; k < degree && !power.is_zero(); ++k)
        power = remainder(expander_.field().product(power, product));
    return power.is_zero();
}

std::map<std::size_t, SparsePolynomial> Elimination::replacements(const Branch& root) {
    std::map<std::size_t, SparsePolynomial> result;
    std::size_t count = 0;
    while (count < root.steps.size()) {
        const Substitution& step = root.steps[count];
        if (step.degree != 1 || coefficients_in(step.relation, step.symbol)[1].total_degree() > 0) break;
        ++count;
    }
    // The replacement of a symbol may contain symbols that are replaced later.
    while (count-- > 0) {
        const Substitution& step = root.steps[count];
        const std::vector<SparsePolynomial> powers = coefficients_in(step.relation, step.symbol);
        SparsePolynomial value = powers[0] * SparsePolynomial(Rational(-1) / powers[1].coefficient(0));
        for (const auto& [symbol, by] : result) {
            if (value.degree_in(symbol) > 0) value = polynomial_value(coefficients_in(value, symbol), by);
        }
        result.emplace(step.symbol, std::move(value));
    }
    return result;
}

/// Removes trivial equations and factors that do not vanish. Returns false if no values satisfy the
/// equations.
bool Elimination::simplify(BranchState& state) {
    for (Equation& equation : state.equations)
        equation.polynomial = without_factors(std::move(equation.polynomial), state.nonzero);
    std::erase_if(state.equations, [](const Equation& e) { return e.polynomial.is_zero(); });
    return std::ranges::none_of(state.equations,
                                [](const Equation& e) { return e.polynomial.total_degree() == 0; });
}

/// Returns false if something that must not vanish is 0.
bool Elimination::apply(BranchState& state, const Substitution& step) {
    if (step.degree > 1) {
        state.monic.push_back(step);
    } else {
        state.solved.insert(step.symbol);
        // A variable that was a root is now determined, so that its relation becomes an equation again.
        const auto known = std::ranges::find(state.monic, step.symbol, &Substitution::symbol);
        if (known != state.monic.end()) {
            state.equations.push_back({known->relation, block_.hypotheses.front().offset});
            state.monic.erase(known);
        }
        for (Substitution& monic : state.monic) monic.relation = reduced(monic.relation, step);
    }
    for (Equation& equation : state.equations) equation.polynomial = reduced(equation.polynomial, step);
    std::set<std::size_t> nonzero;
    for (const std::size_t factor : state.nonzero) {
        const SparsePolynomial before = expander_.field().factors()[factor];
        const SparsePolynomial after = reduced(before, step);
        if (after.is_zero()) return false;
        if (after == before) {
            nonzero.insert(factor);
        } else {
            nonzero.merge(factors_of(after));
        }
    }
    state.nonzero = std::move(nonzero);
    return true;
}

void Elimination::grow(Branch& branch) {
    if (branch.end != Branch::End::unknown) return;
    if (++branches_ > most_branches) {
        throw Error(ErrorCode::limit_exceeded,
                    "the hypotheses lead to more than " + std::to_string(most_branches) +
                        " cases; state with \"assume\" which of their pivots do not vanish",
                    {}, block_.hypotheses.front().offset);
    }
    BranchState state = std::move(branch.state);
    branch.state = {};
    while (true) {
        if (!simplify(state)) {
            branch.end = Branch::End::impossible;
            return;
        }
        if (state.equations.empty()) {
            branch.end = Branch::End::solved;
            return;
        }
        const std::optional<Candidate> candidate = best_candidate(state);
        if (!candidate) {
            if (!state.by_split) {
                throw Error(
                    ErrorCode::syntax,
                    "this hypothesis cannot be solved: it is linear neither in a value of a map nor in "
                    "a variable, and no variable has its highest power with a constant coefficient",
                    {}, state.equations.front().offset);
            }
            branch.end = Branch::End::open;
            return;
        }
        if (!candidate->doubtful.empty()) {
            split(branch, std::move(state), *candidate);
            return;
        }
        branch.steps.push_back(candidate->step);
        state.equations.erase(state.equations.begin() + static_cast<std::ptrdiff_t>(candidate->equation));
        if (!apply(state, branch.steps.back())) {
            branch.end = Branch::End::impossible;
            return;
        }
    }
}

void Elimination::split(Branch& branch, BranchState state, const Candidate& candidate) {
    branch.end = Branch::End::split;
    branch.pivot = expander_.field().factors()[candidate.doubtful.front()];
    branch.branches.resize(2);
    BranchState& zero = branch.branches[1].state;
    zero = state;
    zero.by_split = true;
    zero.zero.insert(candidate.doubtful.front());
    zero.equations.push_back({branch.pivot, state.equations[candidate.equation].offset});
    state.nonzero.insert(candidate.doubtful.front());
    branch.branches[0].state = std::move(state);
}

}  // namespace blossom::proofs
