#include <blossom/proofs/formatter.hpp>
#include <blossom/proofs/parser.hpp>
#include <blossom/proofs/prover.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <set>

#include "chapters/claims.hpp"

namespace blossom::worked {

namespace {

/// The most terms of an expansion that are written out.
constexpr std::size_t most_terms = 24;

/// A block with one claim, decided, and where it was proved the largest case that can be read.
struct Decided {
    proofs::Block block;
    proofs::Decision decision;
    std::optional<WrittenCase> written;
};

[[noreturn]] void refuse(std::string_view statement, const Error& error) {
    if (!error.offset()) throw Error(error);
    const auto [line, column] = proofs::place_of(statement, *error.offset());
    throw Error(
        error.code(),
        "line " + std::to_string(line) + ", column " + std::to_string(column) + ": " + error.message(),
        error.field(), error.offset());
}

bool is_claim(const proofs::Statement& statement) {
    return statement.kind == proofs::StatementKind::claim || statement.kind == proofs::StatementKind::refute;
}

/// Errors: `syntax`; `wrong_arity` unless there is one claim.
proofs::Block only_block(std::string_view statement, const Limits& limits) {
    const proofs::Document document = proofs::parse(statement, limits);
    if (!document.errors.empty()) refuse(statement, document.errors.front());
    std::optional<proofs::Block> found;
    std::ptrdiff_t claims = 0;
    for (const proofs::Block& block : document.blocks) {
        const std::ptrdiff_t more = std::ranges::count_if(block.statements, is_claim);
        if (more > 0) found = block;
        claims += more;
    }
    if (claims == 1) return *found;
    throw Error(ErrorCode::wrong_arity,
                R"(a worked example is made of a statement with one line "claim" or "refute", not with )" +
                    std::to_string(claims),
                "/statement");
}

Decided decided(std::string_view statement, const Limits& limits) {
    Decided result{only_block(statement, limits), {}, {}};
    const auto keep = [&](const proofs::ProvedCase& proved) {
        const bool readable = proved.left.numerator.size() <= most_terms;
        if (readable && is_written(proved.block)) result.written = {proved.block, proved.relation};
    };
    result.decision = proofs::decide(result.block, limits, {.on_proof = keep}).front();
    if (const Error* error = result.decision.error()) refuse(statement, *error);
    return result;
}

/// The case of the counterexample, written out where it can be.
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

std::string cases_text(std::size_t cases) {
    return std::to_string(cases) + (cases == 1 ? " case" : " cases");
}

/// Every map with its coefficients: b(x) = b_0 + b_1 x + ....
std::vector<Formula> general_maps(Document& document, const WrittenCase& written, GroundFormulas& formulas) {
    std::vector<Formula> equations;
    const std::string variable = free_letter(written.block);
    for (const proofs::GroundMap& map : written.block.maps) {
        SymbolicMap any;
        std::vector<Formula> terms;
        for (std::size_t k = 0; k < map.coefficients.size(); ++k) {
            any.coefficients.push_back(formulas(map.coefficients[k]));
            std::vector<Formula> factors{any.coefficients.back()};
            if (k > 0) factors.push_back(power(symbol(variable), number(k)));
            terms.push_back(product(std::move(factors)));
        }
        document.maps.push_back({map.name, map.name, variable, std::move(any)});
        equations.push_back(equation({call(map.name, {symbol(variable)}), sum(std::move(terms))}));
    }
    return equations;
}

void append_expansions(Document& document, const WrittenCase& written, const Limits& limits) {
    GroundFormulas formulas(written.block);
    proofs::Expander expand(written.block, limits);
    const auto expansion = [&](proofs::NodeId node) {
        const proofs::Fraction fraction = expand.field().reduced(expand(node));
        return equation({formulas(node), formulas.expanded(fraction, expand.field().factors())});
    };
    const std::vector<Formula> maps = general_maps(document, written, formulas);
    const std::vector<proofs::NodeId> applications = applications_of(written);
    if (!applications.empty()) {
        std::vector<Formula> values;
        values.reserve(applications.size());
        for (const proofs::NodeId node : applications) values.push_back(expansion(node));
        document.steps.push_back(
            StepBuilder("Every value by coefficients")
                .say("The maps are any polynomials of their degrees; their coefficients are variables too:")
                .show(maps)
                .say("A blossom value has the elementary symmetric functions of its arguments, divided by "
                     "binomial coefficients, in the place of the powers:")
                .show(std::move(values))
                .done());
    }
    document.steps.push_back(StepBuilder("Both sides expanded")
                                 .say("Put in, the two sides become")
                                 .show({expansion(written.relation.left), expansion(written.relation.right)})
                                 .say("These are the same in every variable, and so for all values of them.")
                                 .done());
    document.result.emplace_back(
        Display{{equation({formulas(written.relation.left), formulas(written.relation.right)})}});
}

}  // namespace

Table statement_table(const proofs::Block& block) {
    Table table{"The statement in the identity language.", {"statement"}, {}};
    for (const proofs::Statement& line : block.statements) {
        table.rows.push_back({Cell(proofs::to_text(line).c_str())});
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

std::string free_letter(const proofs::GroundBlock& block) {
    for (const char* letter : {"x", "y", "z", "w"}) {
        if (std::ranges::find(block.symbols, letter, &proofs::Symbol::name) == block.symbols.end())
            return letter;
    }
    return "tau";
}

Formula question(const WrittenCase& written) {
    GroundFormulas formulas(written.block);
    return relation("≟", {formulas(written.relation.left), formulas(written.relation.right)});
}

std::vector<proofs::NodeId> applications_of(const WrittenCase& written) {
    std::vector<proofs::NodeId> nodes;
    std::vector<Formula> known;
    GroundFormulas formulas(written.block);
    for (const proofs::NodeId node :
         proofs::nodes_below(written.block, {written.relation.left, written.relation.right})) {
        if (written.block.nodes[node].kind != proofs::NodeKind::application) continue;
        Formula formula = formulas(node);
        if (std::ranges::find(known, formula) != known.end()) continue;
        known.push_back(std::move(formula));
        nodes.push_back(node);
    }
    return nodes;
}

void append_proof(Document& document, const DecidedClaim& claim, const std::optional<WrittenCase>& written,
                  const Limits& limits) {
    const proofs::Decision& decision = claim.decision;
    const std::size_t cases = decision.cases.size();
    if (written) {
        append_expansions(document, *written, limits);
    } else {
        document.steps.push_back(
            StepBuilder("Both sides expanded")
                .say(
                    "Both sides were expanded as rational functions of the variables and of the coefficients "
                    "of the maps, after the hypotheses, if there are any, had been solved for "
                    "coefficients. They have the same normal form. Its " +
                    std::to_string(decision.terms()) + " terms in " + cases_text(cases) +
                    " are not written out.")
                .done());
    }
    std::string holds = "This holds for all maps of the degrees and all values of the variables";
    std::string before = ", where ";
    for (const proofs::Condition& condition : decision.conditions()) {
        std::string text = condition.text;
        text.replace(text.find("!="), 2, "≠");
        holds += before + text;
        before = ", ";
    }
    document.result.emplace_back(Paragraph{holds + "."});
    if (cases > 1) {
        document.result.emplace_back(
            Paragraph{"The other cases, " + cases_text(cases) + " in all, were decided in the same way."});
    }
    document.check = {
        {Paragraph{
            "The statement was read a second time by a program that shares nothing with the first: both "
            "sides have "
            "the same values at points that it chose, and it accepts the certificate of the expansion."}},
        decision.verdict() == proofs::Verdict::proved,
        "The claim is proved."};
}

Document claim_decided(std::string_view statement, const Limits& limits) {
    Decided decided_claim = decided(statement, limits);
    const proofs::Decision& decision = decided_claim.decision;
    const bool proved = decision.verdict() == proofs::Verdict::proved;
    Document document;
    document.title = std::string(proved ? "A proof" : "A refutation");
    if (!decided_claim.block.title.empty()) document.title += ": " + decided_claim.block.title;
    document.style = BlossomStyle::brackets;
    document.statement.emplace_back(
        Paragraph{"The question is whether this holds for all maps and all values of the variables."});
    document.statement.emplace_back(statement_table(decided_claim.block));
    if (!proved) decided_claim.written = case_of(decided_claim.block, *decision.counterexample(), limits);
    const bool has_hypotheses = decided_claim.written && !decided_claim.written->block.hypotheses.empty();
    if (proved && has_hypotheses) decided_claim.written.reset();
    if (decided_claim.written) {
        auto parameters = decided_claim.written->block.parameters;
        const auto& more = decided_claim.written->relation.parameters;
        parameters.insert(parameters.end(), more.begin(), more.end());
        Text text = parameters_text(parameters);
        if (text.empty()) {
            text = "Written out:";
        } else {
            text.append(std::string(" this is, written out:"));
            Text sentence{"Here, "};
            for (const Text::Part& part : text.parts()) sentence.append(part);
            text = std::move(sentence);
        }
        document.statement.emplace_back(Paragraph{std::move(text)});
        document.statement.emplace_back(Display{{question(*decided_claim.written)}});
    }
    const DecidedClaim claim{decided_claim.block, decision};
    (proved ? append_proof : append_refutation)(document, claim, decided_claim.written, limits);
    return document;
}

}  // namespace blossom::worked
