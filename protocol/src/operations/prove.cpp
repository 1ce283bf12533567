#include <fmt/format.h>
#include <blossom/proofs/parser.hpp>

#include <algorithm>
#include <memory>

#include "decisions.hpp"
#include "table.hpp"

namespace blossom::protocol {

namespace {

/// A line of a statement with the block that it stands in.
struct DecidedLine {
    std::shared_ptr<const proofs::Block> block;
    proofs::Decision decision;
};

/// The decisions of all lines of a statement. Errors: the first one in it, with its offset.
std::vector<DecidedLine> decisions_of(const std::string& statement, const Limits& limits) {
    // The message contains the place, because a response has no offset.
    const auto refuse = [&](const Error& error) {
        if (!error.offset()) throw Error(error);
        const auto [line, column] = proofs::line_and_column(statement, *error.offset());
        throw error.at(Place()).saying(fmt::format("line {}, column {}: {}", line, column, error.message()));
    };
    proofs::Document document = proofs::parse(statement, limits);
    if (!document.errors.empty()) refuse(document.errors.front());
    proofs::require_claim(document);
    std::vector<DecidedLine> decisions;
    for (proofs::Block& one : document.blocks) {
        const auto block = std::make_shared<const proofs::Block>(std::move(one));
        for (proofs::Decision& decision : proofs::decide(*block, limits)) {
            // If one case exceeds a limit, the others are still decided; any other error is an error of the
            // request.
            const bool nothing = decision.verdict() == proofs::Verdict::undecided ||
                                 decision.verdict() == proofs::Verdict::disagreement;
            if (nothing) refuse(*decision.error());
            decisions.push_back({block, std::move(decision)});
        }
    }
    return decisions;
}

/// The decisions on one text or on several.
std::vector<DecidedLine> all_decisions(const Json& value, const Limits& limits) {
    if (!value.array()) return decisions_of(read_text(value), limits);
    std::vector<DecidedLine> decisions;
    for (auto& lines :
         read_list(value, [&](const Json& text) { return decisions_of(read_text(text), limits); }))
        std::ranges::move(lines, std::back_inserter(decisions));
    if (decisions.empty()) throw Error(ErrorCode::wrong_arity, "there is no statement");
    return decisions;
}

Answer answer_prove(Request& request, const Limits& limits) {
    const auto decisions =
        request.required("statement", [&](const Json& value) { return all_decisions(value, limits); });
    request.finish();
    // The first refuted line determines the verdict.
    const auto refuted = std::ranges::find_if(decisions, [](const DecidedLine& line) {
        return line.decision.verdict() == proofs::Verdict::refuted;
    });
    const DecidedLine& first = refuted == decisions.end() ? decisions.front() : *refuted;
    Json result = to_json(*first.block, first.decision);
    if (decisions.size() == 1) return result;
    Json::Array lines;
    for (const DecidedLine& line : decisions) lines.push_back(to_json(*line.block, line.decision));
    result["lines"] = std::move(lines);
    return result;
}

std::string render_prove(const Answered& answered) { return to_text(answered.result()) + "\n"; }

}  // namespace

Operation prove_operation() {
    return {
        .summary = "Decide statements of the identity language, exactly and for all values",
        .documentation = "A claim is proved for all maps and all values, or refuted with a counterexample.",
        .request = {{required("statement", Shape::one_of({ValueKind::text, Shape::list(ValueKind::text, 1)}),
                              "a text of the identity language, or several")}},
        .result = decision_members(),
        .example = {"prove", "-e", "b[s,t] == (4*b((s+t)/2) - b(s) - b(t))/2", "--degree", "b=2"},
        .options = {},
        .answer = answer_prove,
        .render = render_prove,
        .has_own_command = true,
    };
}

}  // namespace blossom::protocol
