#include "decision_text.hpp"

#include <fmt/format.h>
#include <blossom/proofs/case_groups.hpp>
#include <blossom/proofs/formatter.hpp>
#include <blossom/proofs/witness_maps.hpp>

#include <algorithm>
#include <set>

namespace blossom::cli {

namespace {

using proofs::CaseDecision;
using proofs::Decision;
using proofs::Expectation;
using proofs::Parameters;
using proofs::Verdict;

/// "0..6", "1, 3", "1..3, 7"
std::string runs_text(const proofs::Cases& cases) {
    std::vector<std::string> runs;
    for (const auto& [first, last] : proofs::runs_of(cases)) {
        runs.push_back(first == last       ? fmt::format("{}", first)
                       : first + 1 == last ? fmt::format("{}, {}", first, last)
                                           : fmt::format("{}..{}", first, last));
    }
    return fmt::format("{}", fmt::join(runs, ", "));
}

/// "n in 1..4, k in 0..n", as written.
std::string ranges_text(const proofs::Block& block, const Decision& decision) {
    std::vector<std::string> ranges;
    for (const proofs::Range& range : proofs::ranges_of(block, block.statements[decision.statement])) {
        ranges.push_back(fmt::format("{} in {}..{}", range.name, proofs::to_text(range.first),
                                     proofs::to_text(range.last)));
    }
    return fmt::format("{}", fmt::join(ranges, ", "));
}

std::string tuples_text(const proofs::Cases& cases) {
    constexpr std::size_t most = 8;
    std::vector<std::string> names;
    for (const auto& [name, value] : cases.front()->parameters) names.push_back(name);
    std::vector<std::string> tuples;
    for (const CaseDecision* one : cases) {
        if (tuples.size() == most) {
            tuples.push_back(fmt::format("and {} more", cases.size() - most));
            break;
        }
        std::vector<long long> values;
        for (const auto& [name, value] : one->parameters) values.push_back(value);
        tuples.push_back(fmt::format("({})", fmt::join(values, ", ")));
    }
    return fmt::format("({}) = {}", fmt::join(names, ", "), fmt::join(tuples, ", "));
}

std::string parameters_of(const proofs::Block& block, const Decision& decision, const proofs::Cases& cases) {
    const auto names = cases.front()->parameters.size();
    if (names == 0) return "";
    if (names == 1) return fmt::format("{} = {}", cases.front()->parameters.front().first, runs_text(cases));
    return cases.size() == decision.cases.size() ? ranges_text(block, decision) : tuples_text(cases);
}

/// What the proved cases need that no line of the block says: "a != b", or by cases where they need different
/// things.
std::string conditions_text(const proofs::Block& block, const Decision& decision) {
    const std::vector<proofs::CaseGroup> groups = proofs::groups_by_condition(decision);
    std::vector<std::string> parts;
    std::size_t shown = 0;
    constexpr std::size_t most_groups = 3;
    for (const auto& [needed, cases] : groups) {
        if (needed.empty()) continue;
        if (shown++ == most_groups) {
            parts.push_back(fmt::format("and so on for {} more kinds of cases", groups.size() - most_groups));
            break;
        }
        const std::string where = groups.size() == 1 ? "" : parameters_of(block, decision, cases);
        parts.push_back(
            fmt::format("{}{}", fmt::join(needed, ", "), where.empty() ? "" : " (" + where + ")"));
    }
    return fmt::format("{}", fmt::join(parts, "; "));
}

/// The parameters of the cases with this verdict, or their ranges if all cases have it. Empty without
/// parameters.
std::string cases_text(const proofs::Block& block, const Decision& decision, Verdict verdict) {
    const proofs::Cases cases = proofs::cases_with(decision, verdict);
    return cases.empty() ? "" : parameters_of(block, decision, cases);
}

/// "for n = 1, 3; holds for n = 2, 4"
std::string verdicts_text(const proofs::Block& block, const Decision& decision) {
    const Verdict worst = decision.verdict();
    std::string text;
    for (const Verdict verdict : {worst, Verdict::refuted, Verdict::undecided, Verdict::proved}) {
        if (verdict == worst && !text.empty()) continue;
        const std::string cases = cases_text(block, decision, verdict);
        if (cases.empty()) continue;
        const std::string word = verdict == worst ? ""
                                 : verdict == Verdict::proved && worst == Verdict::refuted
                                     ? "holds "
                                     : std::string(proofs::verdict_name(verdict)) + " ";
        text += fmt::format("{}{}for {}", text.empty() ? "" : "; ", word, cases);
    }
    return text;
}

std::string_view complaint(const Decision& decision) {
    if (decision.as_expected() || decision.verdict() == Verdict::undecided ||
        decision.verdict() == Verdict::disagreement) {
        return "";
    }
    if (decision.expectation == Expectation::proof) return "  (expected: proved)";
    return decision.verdict() == Verdict::proved ? "  (expected: refuted)"
                                                 : "  (expected: refuted in every case)";
}

std::string notes(const Decision& decision) {
    std::set<std::string> lines;
    for (const CaseDecision& one : decision.cases) {
        for (const std::string& open : one.open) {
            lines.insert(fmt::format("    a pivot was assumed not to vanish: the case {} is open\n", open));
        }
        if (!one.holds_if.empty())
            lines.insert(fmt::format("    it holds if {}\n", fmt::join(one.holds_if, ", ")));
    }
    return fmt::format("{}", fmt::join(lines, ""));
}

/// "n = 2, a(t) = t (degree 2), t = 0" and both sides, on indented lines, with commands that compute the
/// values.
std::string counterexample_text(const proofs::Counterexample& counterexample) {
    std::vector<std::string> parts;
    for (const auto& [name, value] : counterexample.parameters)
        parts.push_back(fmt::format("{} = {}", name, value));
    for (const proofs::WitnessMap& map : counterexample.maps) {
        parts.push_back(fmt::format("{}({}) = {} ({})", map.name, fmt::join(proofs::variables_of(map), ", "),
                                    map.text, proofs::degrees_text(map)));
    }
    for (const auto& [name, value] : counterexample.variables)
        parts.push_back(fmt::format("{} = {}", name, to_string(value)));
    for (const std::string& root : counterexample.roots) parts.push_back(root);
    std::string text =
        fmt::format("    {}\n    left side {}, right side {}\n",
                    parts.empty() ? "without any choice" : fmt::format("{}", fmt::join(parts, ", ")),
                    counterexample.left, counterexample.right);
    constexpr std::size_t most_values = 6;
    std::size_t shown = 0;
    std::size_t width = 0;
    for (const proofs::WitnessValue& value : counterexample.values)
        width = std::max(width, value.text.size());
    for (const proofs::WitnessValue& value : counterexample.values) {
        if (shown++ == most_values) {
            text += fmt::format("    ... and {} more values\n", counterexample.values.size() - most_values);
            break;
        }
        text += value.command.empty() ? fmt::format("    {}\n", value.text)
                                      : fmt::format("    {:<{}}  $ {}\n", value.text, width, value.command);
    }
    return text;
}

}  // namespace

std::string readable(const proofs::Block& block, const Decision& decision, const std::string& title,
                     const Style& style) {
    const std::string verdict = fmt::format("{:<9}", proofs::verdict_name(decision.verdict()));
    const std::string conditions =
        decision.verdict() == Verdict::proved ? conditions_text(block, decision) : "";
    std::string text;
    if (!conditions.empty()) text = fmt::format("if {}:\n  ", conditions);
    text += decision.as_expected() ? style.good(verdict) : style.bad(verdict);
    text += " " + title;
    const std::string verdicts = verdicts_text(block, decision);
    if (!verdicts.empty()) text += "  " + verdicts;
    if (decision.verdict() == Verdict::proved) {
        text += fmt::format("  ({} {}, {} {})", decision.cases.size(),
                            decision.cases.size() == 1 ? "case" : "cases", decision.terms(),
                            decision.terms() == 1 ? "term" : "terms");
    }
    text += style.bad(std::string(complaint(decision))) + "\n" + notes(decision);
    if (const proofs::Counterexample* found = decision.counterexample()) text += counterexample_text(*found);
    return text;
}

}  // namespace blossom::cli
