#include "decided_case.hpp"

#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>

#include "node_text.hpp"

namespace blossom::proofs {

/// The state of a walk through the branches of one claim.
struct BlockCase::Walk {
    const Relation& relation;
    CaseDecision& decision;
    CaseOutcome& outcome;
    SparsePolynomial difference;
    std::vector<SparsePolynomial> nonzero;
    std::vector<Substitution> steps;
    std::vector<std::string> pivots;  ///< "a != b": what the branches on the path require
    std::size_t agreed = 0;
};

std::vector<std::string> BlockCase::names() const {
    std::vector<std::string> names;
    names.reserve(block_.symbols.size());
    for (const Symbol& symbol : block_.symbols) names.push_back(symbol.name);
    return names;
}

/// "a != b" for a difference of two names, otherwise "polynomial != 0".
std::string BlockCase::condition_text(const SparsePolynomial& factor, std::string_view sign) const {
    const std::vector<std::string> names = this->names();
    const bool difference = factor.size() == 2 && factor.coefficient(0) == Rational(1) &&
                            factor.coefficient(1) == Rational(-1) && factor.total_degree() == 1 &&
                            factor.degree(1) == 1;
    if (!difference) return to_text(factor, names) + " " + std::string(sign) + " 0";
    std::string sides[2];
    for (std::size_t i = 0; i < names.size(); ++i) {
        for (std::size_t term = 0; term < 2; ++term) {
            if (factor.exponent(term, i) == 1) sides[term] = names[i];
        }
    }
    return sides[0] + " " + std::string(sign) + " " + sides[1];
}

/// The base of a power, because it vanishes where the power does.
NodeId BlockCase::base_of(NodeId node) const {
    while (block_.nodes[node].kind == NodeKind::power) node = block_.nodes[node].operands[0];
    return node;
}

std::optional<std::size_t> BlockCase::place_of_divisor(NodeId divisor) const {
    for (const Node& node : block_.nodes) {
        if (node.kind == NodeKind::quotient && node.operands[1] == divisor) return node.offset;
    }
    return std::nullopt;
}

bool BlockCase::has_coefficients(std::size_t factor) {
    const SparsePolynomial& polynomial = expander_.field().factors()[factor];
    for (std::size_t i = 0; i < block_.symbols.size(); ++i) {
        if (block_.symbols[i].is_coefficient && polynomial.degree_in(i) > 0) return true;
    }
    return false;
}

/// Every factor of every divisor in the claim, the hypotheses and the assumptions: it may have cancelled, but
/// where it vanishes they are undefined. Hypotheses "for all" values of a variable give no condition on
/// single values. A divisor made of values of maps is shown as it is in the statement, others by their
/// factors.
std::set<std::size_t> BlockCase::add_conditions(const Relation& relation, CaseDecision& decision) {
    std::set<std::size_t> nonzero;
    const auto add = [&](Condition condition) {
        if (std::ranges::find(decision.conditions, condition.text, &Condition::text) ==
            decision.conditions.end())
            decision.conditions.push_back(std::move(condition));
    };
    const auto take = [&](std::set<std::size_t> factors, const std::vector<std::size_t>& quantified,
                          const auto& shown) {
        std::erase_if(factors, [&](std::size_t factor) {
            return std::ranges::any_of(quantified, [&](std::size_t symbol) {
                return expander_.field().factors()[factor].degree_in(symbol) > 0;
            });
        });
        bool as_written = false;
        bool assumed = true;
        for (const std::size_t factor : factors) {
            const bool known = elimination_.assumed().contains(factor);
            if (has_coefficients(factor)) {
                as_written = true;
                assumed = assumed && known;
            } else {
                add({condition_text(expander_.field().factors()[factor], "!="), known});
            }
        }
        if (as_written) add({shown(), assumed});
        nonzero.merge(factors);
    };
    std::vector<const Relation*> relations{&relation};
    for (const Relation& assumption : block_.assumptions) relations.push_back(&assumption);
    for (const Relation& hypothesis : block_.hypotheses) relations.push_back(&hypothesis);
    for (const Relation* one : relations) {
        for (const NodeId divisor : divisors_below(block_, {one->left, one->right})) {
            if (expander_(divisor).is_zero())
                throw Error(ErrorCode::division_by_zero, "the denominator is zero", {},
                            place_of_divisor(divisor));
            take(elimination_.factors_of(expander_(divisor).numerator), one->quantified,
                 [&] { return node_text(block_, base_of(divisor)) + " != 0"; });
        }
    }
    for (const Relation& one : block_.assumptions) {
        take(elimination_.factors_of(
                 expander_.field().difference(expander_(one.left), expander_(one.right)).numerator),
             {}, [&] { return node_text(block_, one.left) + " != " + node_text(block_, one.right); });
    }
    return nonzero;
}

CaseOutcome BlockCase::decide(const Relation& relation, CaseDecision& decision) {
    CaseOutcome outcome;
    const std::set<std::size_t> nonzero = add_conditions(relation, decision);
    for (const std::size_t factor : nonzero)
        outcome.conditions.push_back(expander_.field().factors()[factor]);
    Branch& root = elimination_.root(nonzero);
    elimination_.grow(root);
    Expander& expand = expander_below(root);
    outcome.left = expand(relation.left);
    const Fraction right = expand(relation.right);
    decision.terms = outcome.left.numerator.size();
    Walk way{
        relation,           decision, outcome, expander_.field().difference(outcome.left, right).numerator,
        outcome.conditions, {},       {}};
    try {
        outcome.root = walk(root, way);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::limit_exceeded || way.agreed == 0) throw;
        throw error.saying("it holds in the first case of the hypotheses, but of the other cases " +
                           error.message());
    }
    if (outcome.witness) {
        decision.verdict = Verdict::refuted;
        decision.counterexample = outcome.witness->counterexample;
        return outcome;
    }
    decision.holds_if.clear();
    if (way.agreed == 0) {
        throw Error(
            ErrorCode::syntax,
            !decision.open.empty() ? "the hypotheses leave only cases that are open: " + decision.open.front()
            : decision.conditions.empty()
                ? "the hypotheses contradict each other: they leave no case"
                : "the hypotheses leave no case in which no divisor vanishes and every assumption holds",
            {}, relation.offset);
    }
    decision.verdict = Verdict::proved;
    return outcome;
}

Expander& BlockCase::expander_below(const Branch& root) {
    const auto known = expanders_.find(&root);
    if (known != expanders_.end()) return known->second;
    std::map<std::size_t, SparsePolynomial> replacements = elimination_.replacements(root);
    if (replacements.empty()) return expander_;
    return expanders_.try_emplace(&root, expander_, std::move(replacements)).first->second;
}

Branch BlockCase::walk(Branch& branch, Walk& way) {
    elimination_.grow(branch);
    const SparsePolynomial difference = way.difference;
    const std::vector<SparsePolynomial> nonzero = way.nonzero;
    const std::size_t steps = way.steps.size();
    for (const Substitution& step : branch.steps) {
        way.difference = elimination_.reduced(way.difference, step);
        for (SparsePolynomial& polynomial : way.nonzero) polynomial = elimination_.reduced(polynomial, step);
        const SparsePolynomial leading = coefficients_in(step.relation, step.symbol)[step.degree];
        if (leading.total_degree() > 0) way.nonzero.push_back(leading);
        way.steps.push_back(step);
    }
    Branch walked = walk_below(branch, way);
    walked.steps = branch.steps;
    way.difference = difference;
    way.nonzero = nonzero;
    way.steps.resize(steps);
    return walked;
}

/// A branch with a counterexample ends the walk. If the sides are already equal, no split is needed.
Branch BlockCase::walk_below(Branch& branch, Walk& way) {
    Branch walked;
    walked.end = branch.end;
    if (branch.end == Branch::End::split && !way.difference.is_zero()) return walk_split(branch, way);
    if (branch.end == Branch::End::split) {
        if (!reach_solution(branch, way.steps)) return walk_split(branch, way);
        walked.end = Branch::End::solved;
    }
    if (walked.end == Branch::End::solved) end_of_branch(way);
    return walked;
}

/// Adds the steps from a split to some solved branch below it; returns false and adds none if there is none.
bool BlockCase::reach_solution(Branch& split, std::vector<Substitution>& steps) {
    return std::ranges::any_of(split.branches, [&](Branch& branch) {
        elimination_.grow(branch);
        const std::size_t count = steps.size();
        steps.insert(steps.end(), branch.steps.begin(), branch.steps.end());
        if (branch.end == Branch::End::solved) return true;
        if (branch.end == Branch::End::split && reach_solution(branch, steps)) return true;
        steps.resize(count);
        return false;
    });
}

/// A branch that cannot be decided leaves open the whole case in which its pivot was required to vanish.
Branch BlockCase::open_branch() {
    Branch branch;
    branch.end = Branch::End::open;
    return branch;
}

Branch BlockCase::walk_split(Branch& branch, Walk& way) {
    Branch walked;
    walked.end = Branch::End::split;
    walked.pivot = branch.pivot;
    way.nonzero.push_back(branch.pivot);
    way.pivots.push_back(condition_text(branch.pivot, "!="));
    walked.branches.push_back(walk(branch.branches[0], way));
    way.pivots.pop_back();
    way.nonzero.pop_back();
    if (way.outcome.witness) return walked;
    if (walked.branches[0].end == Branch::End::open) return open_branch();
    way.pivots.push_back(condition_text(branch.pivot, "=="));
    walked.branches.push_back(walk(branch.branches[1], way));
    way.pivots.pop_back();
    if (walked.branches[1].end == Branch::End::open) {
        leave_open(branch.pivot, way);
        walked.branches[1] = open_branch();
    }
    return walked;
}

void BlockCase::leave_open(const SparsePolynomial& pivot, Walk& way) {
    way.decision.open.push_back(condition_text(pivot, "=="));
    way.outcome.conditions.push_back(pivot);
    const std::string text = condition_text(pivot, "!=");
    if (std::ranges::find(way.decision.conditions, text, &Condition::text) == way.decision.conditions.end())
        way.decision.conditions.push_back({text});
}

void BlockCase::end_of_branch(Walk& way) {
    if (std::ranges::any_of(way.nonzero, [](const SparsePolynomial& p) { return p.is_zero(); })) return;
    if (!elimination_.vanishes(way.difference, way.steps, way.nonzero)) {
        way.outcome.witness =
            find_counterexample(block_, way.relation, expander_, way.steps, way.difference, way.nonzero);
        way.outcome.steps = way.steps;
        return;
    }
    if (way.agreed++ > 0) return;
    way.outcome.steps = way.steps;
    way.decision.holds_if = way.pivots;
}

}  // namespace blossom::proofs
