#include <blossom/proofs/prover.hpp>
#include <blossom/rational/resource_budget.hpp>

#include <algorithm>

#include "decided_case.hpp"
#include "second_opinion.hpp"

namespace blossom::proofs {

namespace {

/// The decision of one block.
class BlockDecision {
public:
    BlockDecision(const Block& block, const Limits& limits, const DecisionOptions& options)
        : block_(block), limits_(limits), options_(options), opinion_(block, unfit(block, limits), limits) {
        for (std::size_t i = 0; i < block.statements.size(); ++i) {
            const Statement& statement = block.statements[i];
            if (statement.kind != StatementKind::claim && statement.kind != StatementKind::refute) continue;
            const Expectation expectation = statement.kind == StatementKind::claim ? Expectation::proof
                                            : statement.some ? Expectation::some_refutation
                                                             : Expectation::refutation;
            decisions_.push_back({i, statement.offset, expectation, {}});
        }
    }

    std::vector<Decision> run() {
        try {
            for (const Parameters& parameters : parameter_choices(block_, limits_)) decide_choice(parameters);
        } catch (const Error& error) {
            for (Decision& decision : decisions_) add_error(decision, {}, error);
        }
        for (Decision& decision : decisions_) {
            if (!decision.cases.empty()) continue;
            add_error(decision, {},
                      Error(ErrorCode::syntax, "there is no case to decide: a range is empty", {},
                            decision.offset));
        }
        compare_cases();
        return std::move(decisions_);
    }

private:
    /// Any other problem of the block is an error of every line.
    static std::set<std::size_t> unfit(const Block& block, const Limits& limits) {
        try {
            const std::vector<Parameters> choices = parameter_choices(block, limits);
            return choices.empty() ? std::set<std::size_t>{} : unfit_claims(block, choices.front(), limits);
        } catch (const Error&) {
            return {};
        }
    }

    static void add_error(Decision& decision, const Parameters& parameters, const Error& error) {
        CaseDecision failed;
        failed.parameters = parameters;
        record(failed, error, decision.offset);
        decision.cases.push_back(std::move(failed));
    }

    void add_errors(const Parameters& parameters, const Error& error) {
        for (Decision& decision : decisions_) add_error(decision, parameters, error);
    }

    static void record(CaseDecision& decision, const Error& error, std::size_t offset) {
        decision.verdict = Verdict::undecided;
        decision.counterexample.reset();
        decision.error = error.offset() ? error : error.at(Place()).at(offset);
    }

    void decide_choice(const Parameters& parameters) {
        const ResourceBudget budget(limits_);
        std::optional<GroundBlock> grounded;
        std::optional<BlockCase> block_case;
        try {
            grounded = ground(block_, parameters, limits_);
            block_case.emplace(*grounded, limits_);
        } catch (const Error& error) {
            return add_errors(parameters, error);
        } catch (const std::bad_alloc& problem) {
            return add_errors(parameters, resource_error(problem));
        }
        for (const Relation& relation : grounded->claims) {
            const auto decision =
                std::ranges::lower_bound(decisions_, relation.statement, {}, &Decision::statement);
            CaseDecision decided;
            decided.parameters = parameters;
            decided.parameters.insert(decided.parameters.end(), relation.parameters.begin(),
                                      relation.parameters.end());
            try {
                check_resources();  // if the budget is used up, no new case begins
                decide_claim(*grounded, *block_case, relation,
                             opinion_.case_of(relation.statement, decided.parameters), decided);
            } catch (const Error& error) {
                record(decided, error, relation.offset);
            } catch (const std::bad_alloc& problem) {
                record(decided, resource_error(problem), relation.offset);
            }
            decision->cases.push_back(std::move(decided));
        }
    }

    void decide_claim(const GroundBlock& grounded, BlockCase& block_case, const Relation& relation,
                      const second::Case& which, CaseDecision& decided) {
        if (relation.error) throw Error(*relation.error);
        const CaseOutcome outcome = block_case.decide(relation, decided);
        if (decided.verdict == Verdict::refuted) {
            const std::optional<std::string> objection = opinion_.on_refutation(grounded, which, outcome);
            // If there are several roots, the second road may have used one at which the sides agree.
            if (objection && !outcome.witness->algebraic.empty()) {
                throw Error(
                    ErrorCode::limit_exceeded,
                    "the sides differ at a root of the hypotheses that the second reading did not reach: " +
                        *objection,
                    {}, relation.offset);
            }
            settle(objection, "refuted", relation.offset, decided);
            return;
        }
        const second::Certificate certificate =
            certificate_of(block_, opinion_.text(), grounded, which, outcome);
        settle(opinion_.on_proof(grounded, which, outcome, certificate), "proved", relation.offset, decided);
        if (options_.on_proof && decided.verdict == Verdict::proved) {
            options_.on_proof(
                {grounded, relation, outcome.left, block_case.expander().field().factors(), certificate});
        }
    }

    /// A verdict stands if the second road has no objection.
    static void settle(const std::optional<std::string>& objection, std::string_view verdict,
                       std::size_t offset, CaseDecision& decided) {
        if (!objection) return;
        decided.verdict = Verdict::disagreement;
        decided.counterexample.reset();
        decided.error =
            Error(ErrorCode::internal,
                  "the two roads disagree, which is an error of the program: the expansion says \"" +
                      std::string(verdict) + "\", but " + *objection,
                  {}, offset);
    }

    /// A verdict on a range is one on all its cases, in which both readers must agree.
    void compare_cases() {
        const bool complete = std::ranges::none_of(decisions_, [](const Decision& decision) {
            return std::ranges::any_of(decision.cases, [](const CaseDecision& decided) {
                return decided.verdict == Verdict::undecided;
            });
        });
        if (!complete || decisions_.empty()) return;
        const std::optional<std::string> objection = opinion_.on_cases(decisions_);
        if (!objection) return;
        for (Decision& decision : decisions_) {
            for (CaseDecision& decided : decision.cases)
                settle(objection, verdict_name(decided.verdict), decision.offset, decided);
        }
    }

    const Block& block_;
    const Limits& limits_;
    const DecisionOptions& options_;
    SecondOpinion opinion_;
    std::vector<Decision> decisions_;
};

std::size_t number_of(const Decision& decision, Verdict verdict) {
    return static_cast<std::size_t>(std::ranges::count(decision.cases, verdict, &CaseDecision::verdict));
}

}  // namespace

std::string_view verdict_name(Verdict verdict) {
    switch (verdict) {
        case Verdict::proved:
            return "proved";
        case Verdict::refuted:
            return "refuted";
        case Verdict::disagreement:
            return "disagreement";
        default:
            return "undecided";
    }
}

Verdict Decision::verdict() const {
    for (const Verdict worst : {Verdict::disagreement, Verdict::refuted, Verdict::undecided}) {
        if (number_of(*this, worst) > 0) return worst;
    }
    return cases.empty() ? Verdict::undecided : Verdict::proved;
}

bool Decision::as_expected() const {
    if (verdict() == Verdict::disagreement) return false;
    if (expectation == Expectation::proof) return verdict() == Verdict::proved;
    const std::size_t refuted = number_of(*this, Verdict::refuted);
    return expectation == Expectation::some_refutation ? refuted > 0 : refuted > 0 && refuted == cases.size();
}

std::size_t Decision::terms() const {
    std::size_t sum = 0;
    for (const CaseDecision& decided : cases) sum += decided.terms;
    return sum;
}

std::vector<Condition> Decision::conditions() const {
    std::vector<Condition> all;
    for (const CaseDecision& decided : cases) {
        for (const Condition& condition : decided.conditions) {
            if (std::ranges::find(all, condition) == all.end()) all.push_back(condition);
        }
    }
    return all;
}

const Counterexample* Decision::counterexample() const {
    const auto found =
        std::ranges::find_if(cases, [](const CaseDecision& c) { return c.counterexample.has_value(); });
    return found == cases.end() ? nullptr : &*found->counterexample;
}

const Error* Decision::error() const {
    const auto found = std::ranges::find_if(cases, [](const CaseDecision& c) { return c.error.has_value(); });
    return found == cases.end() ? nullptr : &*found->error;
}

std::vector<Decision> decide(const Block& block, const Limits& limits, const DecisionOptions& options) {
    return BlockDecision(block, limits, options).run();
}

}  // namespace blossom::proofs
