#include <blossom/core/polynomial_text.hpp>
#include <blossom/proofs/expansion.hpp>
#include <blossom/proofs/prover.hpp>

#include <algorithm>
#include <set>

#include "elimination.hpp"
#include "witness.hpp"

namespace blossom::proofs {

namespace {

/// "a != b" for a difference of two names, otherwise "polynomial != 0".
std::string condition_text(const SparsePolynomial& factor, const std::vector<Symbol>& symbols) {
    std::vector<std::string> names;
    names.reserve(symbols.size());
    for (const Symbol& symbol : symbols) names.push_back(symbol.name);
    const SparsePolynomial zero;
    if (factor.size() == 2 && factor.coefficient(0) == Rational(1) && factor.coefficient(1) == Rational(-1) &&
        factor.total_degree() == 1 && factor.degree(1) == 1) {
        std::string sides[2];
        for (std::size_t i = 0; i < names.size(); ++i) {
            for (std::size_t term = 0; term < 2; ++term) {
                if (factor.exponent(term, i) == 1) sides[term] = names[i];
            }
        }
        return sides[0] + " != " + sides[1];
    }
    return to_text(factor, names) + " != 0";
}

/// Decides the claims of one case; `decisions` has one entry a line, in the order of the lines.
class Case {
public:
    Case(const GroundBlock& block, const Limits& limits)
        : block_(block), expander_(block, limits), elimination_(block, expander_) {}

    void prepare() { elimination_.solve(); }

    void decide(const Relation& relation, Decision& decision, const ProofListener& on_proof) {
        const Fraction left = expander_(relation.left);
        const Fraction right = expander_(relation.right);
        decision.terms += left.numerator.size();
        FractionField& field = expander_.field();
        const SparsePolynomial difference = elimination_.reduced(field.difference(left, right).numerator);
        std::set<std::size_t> conditions = elimination_.conditions();
        add_divisors(relation, conditions);
        for (const auto* list : {&block_.assumptions, &block_.hypotheses}) {
            for (const Relation& other : *list) add_divisors(other, conditions);
        }
        conditions.insert(elimination_.assumed().begin(), elimination_.assumed().end());
        for (const std::size_t factor : conditions) {
            const std::string text = condition_text(field.factors()[factor], block_.symbols);
            if (std::ranges::find(decision.conditions, text) == decision.conditions.end())
                decision.conditions.push_back(text);
        }
        ++decision.cases;
        std::vector<SparsePolynomial> nonzero;
        for (const std::size_t factor : conditions) {
            nonzero.push_back(elimination_.reduced(field.factors()[factor]));
            if (nonzero.back().is_zero()) {
                throw Error(ErrorCode::syntax,
                            "the hypotheses leave no case: they make " +
                                condition_text(field.factors()[factor], block_.symbols) + " impossible",
                            "", relation.offset);
            }
        }
        if (difference.is_zero()) {
            if (on_proof && decision.expects_proof) {
                std::vector<std::size_t> solved;
                for (const auto& solution : elimination_.solutions()) solved.push_back(solution.symbol);
                on_proof({block_, relation, left, field.factors(), std::move(solved)});
            }
            return;
        }
        decision.verdict = Verdict::refuted;
        decision.counterexample =
            find_counterexample(block_, relation, difference, std::move(nonzero), elimination_);
    }

private:
    /// The factors of every divisor in the two sides: it may have cancelled, but where it vanishes the side
    /// is not defined.
    void add_divisors(const Relation& relation, std::set<std::size_t>& conditions) {
        for (const NodeId id : nodes_below(block_, {relation.left, relation.right})) {
            const Node& node = block_.nodes[id];
            if (node.kind != NodeKind::quotient) continue;
            const Fraction divisor = expander_(node.operands[1]);
            for (const auto& [factor, exponent] : expander_.field().factorise(divisor.numerator).factors)
                conditions.insert(factor);
        }
    }

    const GroundBlock& block_;
    Expander expander_;
    Elimination elimination_;
};

void record(Decision& decision, const Error& error) {
    decision.verdict = Verdict::undecided;
    decision.error = error.offset() ? error : Error(error.code(), error.message(), "", decision.offset);
}

std::vector<Decision> lines_of(const Block& block) {
    std::vector<Decision> decisions;
    for (std::size_t i = 0; i < block.statements.size(); ++i) {
        const Statement& statement = block.statements[i];
        const bool claim = statement.kind == StatementKind::claim;
        if (!claim && statement.kind != StatementKind::refute) continue;
        Decision decision;
        decision.statement = i;
        decision.offset = statement.offset;
        decision.expects_proof = claim;
        decisions.push_back(std::move(decision));
    }
    return decisions;
}

}  // namespace

std::string_view verdict_name(Verdict verdict) {
    switch (verdict) {
        case Verdict::proved:
            return "proved";
        case Verdict::refuted:
            return "refuted";
        default:
            return "undecided";
    }
}

std::vector<Decision> decide(const Block& block, const Limits& limits, const ProofListener& on_proof) {
    std::vector<Decision> decisions = lines_of(block);
    const auto is_open = [](const Decision& decision) { return decision.verdict == Verdict::proved; };
    try {
        for (const auto& parameters : parameter_choices(block, limits)) {
            if (std::ranges::none_of(decisions, is_open)) break;
            const GroundBlock grounded = ground(block, parameters, limits);
            Case decided(grounded, limits);
            decided.prepare();
            for (const Relation& relation : grounded.claims) {
                Decision& decision = *std::ranges::find(decisions, relation.statement, &Decision::statement);
                if (!is_open(decision)) continue;
                try {
                    decided.decide(relation, decision, on_proof);
                } catch (const Error& error) {
                    record(decision, error);
                }
            }
        }
    } catch (const Error& error) {
        for (Decision& decision : decisions) {
            if (is_open(decision)) record(decision, error);
        }
    }
    for (Decision& decision : decisions) {
        if (is_open(decision) && decision.cases == 0) {
            record(decision, Error(ErrorCode::syntax, "there is no case to decide: a range is empty", "",
                                   decision.offset));
        }
    }
    return decisions;
}

}  // namespace blossom::proofs
