#include "second_opinion.hpp"

#include <blossom/rational/error.hpp>

#include <algorithm>

namespace blossom::proofs {

namespace {

constexpr std::size_t comparison_points = 2;
constexpr std::uint64_t comparison_seed = 20240229;

second::NamedPolynomial named(const SparsePolynomial& polynomial, const std::vector<Symbol>& symbols) {
    second::NamedPolynomial terms;
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        second::NamedTerm term{polynomial.coefficient(i), {}};
        for (std::size_t j = 0; j < symbols.size(); ++j) {
            const std::size_t exponent = polynomial.exponent(i, j);
            if (exponent > 0) term.powers.emplace_back(symbols[j].name, exponent);
        }
        terms.push_back(std::move(term));
    }
    return terms;
}

std::vector<second::Step> named(const std::vector<Substitution>& steps, const std::vector<Symbol>& symbols) {
    std::vector<second::Step> result;
    result.reserve(steps.size());
    for (const Substitution& step : steps)
        result.push_back({symbols[step.symbol].name, step.degree, named(step.relation, symbols)});
    return result;
}

second::Branch named(const Branch& branch, const std::vector<Symbol>& symbols) {
    second::Branch result;
    result.steps = named(branch.steps, symbols);
    switch (branch.end) {
        case Branch::End::solved:
            result.end = second::Branch::End::agree;
            break;
        case Branch::End::unknown:
        case Branch::End::impossible:
            result.end = second::Branch::End::impossible;
            break;
        case Branch::End::split:
            result.end = second::Branch::End::split;
            break;
        case Branch::End::open:
            result.end = second::Branch::End::open;
    }
    result.pivot = named(branch.pivot, symbols);
    for (const Branch& below : branch.branches) result.branches.push_back(named(below, symbols));
    return result;
}

}  // namespace

second::Certificate certificate_of(const Block& block, const std::string& text, const GroundBlock& grounded,
                                   const second::Case& which, const CaseOutcome& outcome) {
    second::Certificate certificate{block.id, block.title, text,
                                    which,    {},          named(outcome.root, grounded.symbols)};
    for (const SparsePolynomial& condition : outcome.conditions)
        certificate.conditions.push_back(named(condition, grounded.symbols));
    return certificate;
}

SecondOpinion::SecondOpinion(const Block& block, const std::set<std::size_t>& unfit, const Limits& limits)
    : text_(block.text), checker_(limits) {
    for (std::size_t i = 0; i < block.statements.size(); ++i) {
        const Statement& statement = block.statements[i];
        if (statement.kind != StatementKind::claim && statement.kind != StatementKind::refute) continue;
        if (!unfit.contains(i)) {
            lines_.push_back(i);
            continue;
        }
        const std::size_t first = statement.offset - block.offset;
        const std::size_t last =
            i + 1 < block.statements.size() ? block.statements[i + 1].offset - block.offset : text_.size();
        std::replace_if(
            text_.begin() + static_cast<std::ptrdiff_t>(first),
            text_.begin() + static_cast<std::ptrdiff_t>(last), [](char c) { return c != '\n'; }, ' ');
    }
    try {
        reading_.emplace(text_, limits);
    } catch (const Error& error) {
        unread_ = "the second reader cannot read the text: " + error.message();
    }
}

second::Case SecondOpinion::case_of(std::size_t statement, Parameters parameters) const {
    const auto place = std::ranges::find(lines_, statement);
    return {static_cast<std::size_t>(place - lines_.begin()), std::move(parameters)};
}

std::optional<std::string> SecondOpinion::on_cases(const std::vector<Decision>& decisions) {
    if (!reading_) return unread_;
    std::vector<std::pair<std::size_t, Parameters>> ours;
    for (const Decision& decision : decisions) {
        for (const CaseDecision& decided : decision.cases)
            ours.emplace_back(case_of(decision.statement, {}).line, decided.parameters);
    }
    std::vector<std::pair<std::size_t, Parameters>> theirs;
    try {
        for (const second::Case& which : reading_->cases()) theirs.emplace_back(which.line, which.parameters);
    } catch (const Error& error) {
        return "the second reader cannot list the cases: " + error.message();
    }
    std::ranges::sort(ours);
    std::ranges::sort(theirs);
    if (ours == theirs) return std::nullopt;
    return "the second reader finds " + std::to_string(theirs.size()) + " cases, the first one " +
           std::to_string(ours.size()) + ", or other values of the parameters";
}

std::optional<std::string> SecondOpinion::on_proof(const GroundBlock& block, const second::Case& which,
                                                   const CaseOutcome& outcome,
                                                   const second::Certificate& certificate) {
    if (!reading_) return unread_;
    const second::Comparison compared = second::compare(*reading_, which, named(outcome.steps, block.symbols),
                                                        comparison_points, comparison_seed);
    if (compared.result == second::Comparison::Result::no_point) {
        throw Error(
            ErrorCode::limit_exceeded,
            "the second reading of the text found no point that satisfies the hypotheses: " + compared.note);
    }
    if (compared.result != second::Comparison::Result::agree) {
        return "in the second reading of the text the sides differ: " + compared.note;
    }
    const std::string problem = checker_.problem_of(certificate);
    if (!problem.empty()) return "the certificate is refused: " + problem;
    return std::nullopt;
}

std::optional<std::string> SecondOpinion::on_refutation(const GroundBlock& block, const second::Case& which,
                                                        const CaseOutcome& outcome) {
    if (!reading_) return unread_;
    const second::Comparison compared =
        second::confirm(*reading_, which, outcome.witness->values, outcome.witness->algebraic,
                        named(outcome.steps, block.symbols));
    if (compared.result == second::Comparison::Result::differ) return std::nullopt;
    return "it is not a counterexample in the second reading of the text: " + compared.note;
}

}  // namespace blossom::proofs
