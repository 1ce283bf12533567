#include <blossom/proofs/case_groups.hpp>
#include <blossom/proofs/witness_maps.hpp>
#include <blossom/worked/general_statement.hpp>

#include <algorithm>
#include <map>
#include <set>

#include "sentences.hpp"
#include "statement_formulas.hpp"

namespace blossom::worked {

namespace {

using proofs::Decision;
using proofs::Verdict;

std::vector<Formula> formulas_of(const std::vector<std::string>& texts) {
    std::vector<Formula> formulas;
    formulas.reserve(texts.size());
    for (const std::string& text : texts) formulas.push_back(formula_of_text(text));
    return formulas;
}

/// n = 1, ..., 4, 7
Formula runs_formula(const proofs::Cases& cases) {
    std::vector<Formula> values;
    for (const auto& [first, last] : proofs::runs_of(cases)) {
        values.push_back(number(first));
        if (last > first + 2) values.push_back(symbol("…"));
        if (last == first + 2) values.push_back(number(first + 1));
        if (last > first) values.push_back(number(last));
    }
    return equation({symbol(cases.front()->parameters.front().first), list_of(std::move(values))});
}

/// (n, k) = (1, 0), (2, 1)
Text tuples_words(const proofs::Cases& cases) {
    constexpr std::size_t most = 8;
    std::vector<Formula> names;
    for (const auto& [name, value] : cases.front()->parameters) names.push_back(symbol(name));
    std::vector<Text> tuples;
    for (std::size_t i = 0; i < std::min(cases.size(), most); ++i) {
        std::vector<Formula> values;
        for (const auto& [name, value] : cases[i]->parameters) values.push_back(number(value));
        Formula one = tuple(std::move(values));
        tuples.emplace_back(i > 0 ? std::move(one) : equation({tuple(names), std::move(one)}));
    }
    if (cases.size() > most) tuples.emplace_back(std::to_string(cases.size() - most) + " more");
    Text text;
    append_list(text, tuples);
    return text;
}

/// What is said of a decision, by its cases.
class VerdictWords {
public:
    VerdictWords(const proofs::Block& block, const Decision& decision) : block_(block), decision_(decision) {}

    Text write() {
        const Verdict worst = decision_.verdict();
        static const std::vector<std::pair<Verdict, std::string>> beginnings{
            {Verdict::disagreement, "Left open, as the two roads of the prover disagree,"},
            {Verdict::refuted, "Refuted"},
            {Verdict::undecided, "Undecided"},
            {Verdict::proved, "Proved"}};
        for (const auto& [verdict, words] : beginnings) {
            const proofs::Cases cases = proofs::cases_with(decision_, verdict);
            if (cases.empty() && (verdict != worst || !decision_.cases.empty())) continue;
            if (text_.empty()) {
                text_.append(words);
            } else {
                text_.append("; " + continued(verdict));
            }
            if (!cases.empty()) append_for(cases);
            if (verdict == Verdict::proved) append_conditions();
        }
        if (const Error* error = decision_.error()) text_.append(": " + error->message());
        text_.append(".");
        append_notes();
        return std::move(text_);
    }

private:
    static std::string continued(Verdict verdict) {
        return verdict == Verdict::proved ? "it holds"
                                          : "it is " + std::string(proofs::verdict_name(verdict));
    }

    void append_for(const proofs::Cases& cases) {
        const std::size_t names = cases.front()->parameters.size();
        if (names == 0) return;
        text_.append(" for ");
        if (names == 1) return text_.append(runs_formula(cases));
        if (cases.size() < decision_.cases.size()) return text_.append(tuples_words(cases));
        StatementFormulas formulas(block_);
        std::vector<Formula> ranges;
        for (const proofs::Range& range : proofs::ranges_of(block_, block_.statements[decision_.statement]))
            ranges.push_back(formulas.range(range));
        append_list(text_, ranges);
    }

    void append_conditions() {
        const std::vector<proofs::CaseGroup> groups = proofs::groups_by_condition(decision_);
        constexpr std::size_t most_groups = 3;
        std::size_t shown = 0;
        for (const proofs::CaseGroup& group : groups) {
            if (group.needed.empty()) continue;
            if (shown++ == most_groups) return text_.append(", and so on for other cases");
            text_.append(", if ");
            append_list(text_, formulas_of(group.needed));
            if (groups.size() > 1) append_for(group.cases);
        }
    }

    void append_notes() {
        std::set<std::string> open;
        std::map<std::vector<std::string>, proofs::Cases> holds;
        for (const proofs::CaseDecision& one : decision_.cases) {
            open.insert(one.open.begin(), one.open.end());
            if (!one.holds_if.empty()) holds[one.holds_if].push_back(&one);
        }
        for (const auto& [conditions, cases] : holds) {
            text_.append(" It holds if ");
            append_list(text_, formulas_of(conditions));
            if (cases.size() < decision_.cases.size()) append_for(cases);
            text_.append(".");
        }
        for (const std::string& equation : open) {
            text_.append(" The case ");
            text_.append(formula_of_text(equation));
            text_.append(" is open.");
        }
    }

    const proofs::Block& block_;
    const Decision& decision_;
    Text text_;
};

/// b(t) = t^2 of degree 2
Text map_words(const proofs::WitnessMap& map) {
    std::vector<Formula> variables;
    for (const std::string& name : proofs::variables_of(map)) variables.push_back(symbol(name));
    Text text(equation({call(map.name, std::move(variables)), formula_of_text(map.text)}));
    text.append(" of " + proofs::degrees_text(map));
    return text;
}

}  // namespace

Text verdict_in_words(const proofs::Block& block, const Decision& decision) {
    return VerdictWords(block, decision).write();
}

Text counterexample_in_words(const proofs::Counterexample& found) {
    std::vector<Text> choices;
    for (const auto& [name, value] : found.parameters)
        choices.emplace_back(equation({symbol(name), number(value)}));
    for (const proofs::WitnessMap& map : found.maps) choices.push_back(map_words(map));
    for (const auto& [name, value] : found.variables)
        choices.emplace_back(equation({formula_of_text(name), number(value)}));
    for (const std::string& root : found.roots) choices.emplace_back(formula_of_text(root));
    Text text;
    if (!choices.empty()) text.append("For ");
    append_list(text, choices);
    text.append(std::string(choices.empty() ? "The left side is " : " the left side is "));
    text.append(formula_of_text(found.left));
    text.append(" and the right side ");
    text.append(formula_of_text(found.right));
    text.append(".");
    return text;
}

}  // namespace blossom::worked
