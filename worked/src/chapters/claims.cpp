#include <blossom/proofs/formatter.hpp>
#include <blossom/proofs/parser.hpp>
#include <blossom/proofs/prover.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/worked/general_statement.hpp>

#include <algorithm>
#include <map>
#include <optional>

#include "claims.hpp"

namespace blossom::worked {

namespace {

/// The greatest number of terms of an expansion that is written out.
constexpr std::size_t most_terms = 24;

[[noreturn]] void refuse(std::string_view statement, const Error& error) {
    if (!error.offset()) throw Error(error);
    const auto [line, column] = proofs::line_and_column(statement, *error.offset());
    throw error.saying("line " + std::to_string(line) + ", column " + std::to_string(column) + ": " +
                       error.message());
}

/// The case of the counterexample, written out if possible.
std::optional<WrittenCase> case_of(const proofs::Block& block, const proofs::Counterexample& found,
                                   const Limits& limits) {
    for (const auto& parameters : proofs::parameter_choices(block, limits)) {
        proofs::GroundBlock grounded = proofs::ground(block, parameters, limits);
        for (const proofs::Relation& relation : grounded.claims) {
            auto all = parameters;
            all.insert(all.end(), relation.parameters.begin(), relation.parameters.end());
            if (all == found.parameters) {
                if (!is_written(grounded)) return std::nullopt;
                const proofs::Relation chosen = relation;
                return WrittenCase{std::move(grounded), chosen};
            }
        }
    }
    return std::nullopt;
}

/// The general statement as a question: nothing is computed from its formulas.
void append_general(Document& document, const proofs::Block& block, const proofs::Statement& line) {
    const Text declarations = declarations_in_words(block);
    if (!declarations.empty()) document.general.say(declarations);
    ClaimInWords claim = claim_in_words(block, line, "");
    document.general.say("The question is whether this holds for all maps and all values of the variables:");
    claim.claim.name = "≟";
    document.general.show({std::move(claim.claim)});
    if (!claim.after.empty()) document.general.say(std::move(claim.after));
}

/// The case that is written out, if it differs from the general statement.
void append_case(Document& document, const WrittenCase& written) {
    const Display shown{{question(written)}};
    const auto is_shown = [&](const Block& block) {
        const auto* display = std::get_if<Display>(&block);
        return display && display->formulas == shown.formulas;
    };
    if (std::ranges::any_of(document.general, is_shown)) return;
    auto parameters = written.block.parameters;
    const auto& more = written.relation.parameters;
    parameters.insert(parameters.end(), more.begin(), more.end());
    const Text values = parameters_text(parameters);
    Text text(values.empty() ? "Written out:" : "Here, ");
    text.append(values);
    if (!values.empty()) text.append(" this is, written out:");
    document.statement.say(std::move(text));
    document.statement.add(shown);
}

/// The page of one claim; `written` is a case of it that is short enough to read.
Document page_of(const DecidedClaim& claim, std::optional<WrittenCase> written, const Limits& limits) {
    const bool proved = claim.decision.verdict() == proofs::Verdict::proved;
    Document document;
    document.title = std::string(proved ? "A proof" : "A refutation");
    if (!claim.block.title.empty()) document.title += ": " + claim.block.title;
    document.style = BlossomStyle::brackets;
    append_general(document, claim.block, claim.block.statements[claim.decision.statement]);
    document.statement.add(statement_table(claim));
    if (!proved) written = case_of(claim.block, *claim.decision.counterexample(), limits);
    const bool has_hypotheses = written && !written->block.hypotheses.empty();
    if (proved && has_hypotheses) written.reset();
    if (written) append_case(document, *written);
    (proved ? append_proof : append_refutation)(document, claim, written, limits);
    return document;
}

}  // namespace

Table statement_table(const DecidedClaim& claim) {
    using proofs::StatementKind;
    Table table{"The statement in the identity language.", {"statement"}, {}};
    const std::vector<proofs::Statement>& lines = claim.block.statements;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const bool decided = lines[i].kind == StatementKind::claim || lines[i].kind == StatementKind::refute;
        if (!decided || i == claim.decision.statement)
            table.rows.push_back({Cell(proofs::to_text(lines[i]).c_str())});
    }
    return table;
}

Text parameters_text(const std::vector<std::pair<std::string, long long>>& parameters) {
    Text text;
    for (const auto& [name, value] : parameters) {
        text.append(std::string(text.empty() ? "for " : ", "));
        text.append(equation({symbol(name), number(Rational(value))}));
    }
    return text;
}

Formula question(const WrittenCase& written) {
    GroundFormulas formulas(written.block);
    return relation("≟", {formulas(written.relation.left), formulas(written.relation.right)});
}

std::vector<Document> claims_decided(std::string_view statement, const Limits& limits) {
    const proofs::Document text = proofs::parse(statement, limits);
    if (!text.errors.empty()) refuse(statement, text.errors.front());
    proofs::require_claim(text);
    std::vector<Document> pages;
    for (const proofs::Block& block : text.blocks) {
        std::map<std::size_t, WrittenCase> written;
        const auto keep = [&](const proofs::ProvedCase& proved) {
            if (proved.left.numerator.size() <= most_terms && is_written(proved.block))
                written.insert_or_assign(proved.relation.offset, WrittenCase{proved.block, proved.relation});
        };
        for (const proofs::Decision& decision : proofs::decide(block, limits, {.on_proof = keep})) {
            if (const Error* error = decision.error()) refuse(statement, *error);
            const auto found = written.find(decision.offset);
            pages.push_back(page_of({block, decision},
                                    found == written.end() ? std::nullopt : std::optional(found->second),
                                    limits));
        }
    }
    return pages;
}

}  // namespace blossom::worked
