#include <blossom/proofs/prover.hpp>

#include <algorithm>

#include "claims.hpp"

namespace blossom::worked {

namespace {

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
        document.step("Every value by coefficients")
            .say("The maps are any polynomials of their degrees; their coefficients are variables too:")
            .show(maps)
            .say(
                "A blossom value has the elementary symmetric functions of its arguments, divided by "
                "binomial coefficients, in the place of the powers:")
            .show(std::move(values));
    }
    document.step("Both sides expanded")
        .say("Put in, the two sides become")
        .show({expansion(written.relation.left), expansion(written.relation.right)})
        .say("These are the same in every variable, and so for all values of them.");
    document.result.show({equation({formulas(written.relation.left), formulas(written.relation.right)})});
}

}  // namespace

std::string free_letter(const proofs::GroundBlock& block) {
    for (const char* letter : {"x", "y", "z", "w"}) {
        if (std::ranges::find(block.symbols, letter, &proofs::Symbol::name) == block.symbols.end())
            return letter;
    }
    return "tau";
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
        document.step("Both sides expanded")
            .say(
                "Both sides were expanded as rational functions of the variables and of the coefficients "
                "of the maps, after the hypotheses, if there are any, had been solved for "
                "coefficients. They have the same normal form. Its " +
                std::to_string(decision.terms()) + " terms in " + cases_text(cases) +
                " are not written out.");
    }
    std::string holds = "This holds for all maps of the degrees and all values of the variables";
    std::string before = ", where ";
    for (const proofs::Condition& condition : decision.conditions()) {
        std::string text = condition.text;
        text.replace(text.find("!="), 2, "≠");
        holds += before + text;
        before = ", ";
    }
    document.result.say(holds + ".");
    if (cases > 1) {
        document.result.say("The other cases, " + cases_text(cases) +
                            " in all, were decided in the same way.");
    }
    document.check = {
        {Paragraph{
            "The statement was read a second time by a program that shares nothing with the first: both "
            "sides have "
            "the same values at points that it chose, and it accepts the certificate of the expansion."}},
        decision.verdict() == proofs::Verdict::proved,
        "The claim is proved."};
}

}  // namespace blossom::worked
