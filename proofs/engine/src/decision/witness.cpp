#include "witness.hpp"

#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <set>

#include <blossom/proofs/evaluation.hpp>

#include "witness_search.hpp"

namespace blossom::proofs {

namespace {

std::vector<std::string> names_of_variables(const GroundMap& map) {
    std::size_t variables = 0;
    for (const Direction& direction : map.directions) variables += direction.dimension;
    if (variables == 1) return {"t"};
    if (map.directions.size() == 2 && variables == 2) return {"u", "v"};
    return numbered_names("x", variables);
}

WitnessMap written_out(const GroundMap& map, Evaluator& evaluate) {
    const auto exponents = monomials(map.directions);
    std::vector<SparsePolynomial> terms;
    terms.reserve(exponents.size());
    for (std::size_t i = 0; i < exponents.size(); ++i) {
        terms.push_back(SparsePolynomial::term(evaluate(map.coefficients[i]), exponents[i]));
    }
    return {map.name, to_text(sum(terms), names_of_variables(map)), map.directions};
}

struct WrittenArgument {
    std::string readable;
    std::string option;  ///< in the syntax of --at
};

WrittenArgument written_out(const NodeArgument& argument, Evaluator& evaluate) {
    const Rational mass = evaluate(argument.mass);
    std::string coordinates;
    for (const NodeId coordinate : argument.coordinates) {
        coordinates += (coordinates.empty() ? "" : ", ") + to_string(evaluate(coordinate));
    }
    if (argument.coordinates.size() > 1) {
        if (mass == Rational(1)) return {"(" + coordinates + ")", ""};
        return {"<(" + coordinates + "), " + to_string(mass) + ">", ""};
    }
    if (mass == Rational(1)) return {coordinates, coordinates};
    if (mass.is_zero()) {
        if (coordinates == "1") return {"delta", "delta"};
        return {"<" + coordinates + ", 0>", "vector:" + coordinates};
    }
    return {"<" + coordinates + ", " + to_string(mass) + ">", "pair:" + coordinates + ":" + to_string(mass)};
}

/// The value of one application as text, and the command that computes it for maps of one variable.
WitnessValue written_out(const GroundBlock& block, NodeId id, const std::vector<WitnessMap>& maps,
                         Evaluator& evaluate) {
    const Application& application = block.applications[block.nodes[id].index];
    const WitnessMap& map = *std::ranges::find(maps, block.maps[application.map].name, &WitnessMap::name);
    std::string readable;
    std::string options;
    bool has_command = map.directions.size() == 1 && map.directions[0].dimension == 1;
    const bool derivative = application.form == Application::Form::derivative;
    std::vector<std::vector<NodeArgument>> shown = application.arguments;
    if (derivative) shown = {application.places};
    for (const auto& list : shown) {
        if (!readable.empty()) readable += "; ";
        for (std::size_t i = 0; i < list.size(); ++i) {
            const auto [text, option] = written_out(list[i], evaluate);
            readable += (i == 0 ? "" : ", ") + text;
            options += (i == 0 ? "" : ",") + option;
        }
    }
    std::string order;
    std::string name = map.name;
    for (const std::size_t k : application.orders) order += (order.empty() ? "" : ", ") + std::to_string(k);
    if (derivative) name = "D(" + map.name + ", " + order + ")";
    const bool polar = application.form == Application::Form::blossom;
    WitnessValue result{polar ? name + "[" + readable + "]" : name + "(" + readable + ")", ""};
    result.text += " = " + to_string(evaluate(id));
    const bool plain = polar || options.find(':') == std::string::npos;
    if (has_command && plain && !options.empty()) {
        result.command = std::string("blossom ") +
                         (polar        ? "blossom"
                          : derivative ? "derivative"
                                       : "evaluate") +
                         " \"" + map.text + "\" --degree " + std::to_string(map.directions[0].degree) +
                         (derivative ? " --order " + order : "") + " --at " + options;
    }
    return result;
}

/// All nodes in the claim, the hypotheses and the assumptions.
std::set<NodeId> nodes_of_case(const GroundBlock& block, const Relation& relation) {
    std::vector<NodeId> roots{relation.left, relation.right};
    for (const auto* list : {&block.hypotheses, &block.assumptions}) {
        for (const Relation& other : *list) roots.insert(roots.end(), {other.left, other.right});
    }
    return nodes_below(block, std::move(roots));
}

/// The polynomial with all known values substituted.
SparsePolynomial with_values(SparsePolynomial polynomial, const WitnessSearch& choice) {
    for (std::size_t i = 0; i < choice.values().size(); ++i) {
        if (!choice.is_root(i)) polynomial = specialised(polynomial, i, choice.values()[i]);
    }
    return polynomial;
}

/// A map whose coefficients contain roots, which keep their names; nullopt if one has a denominator.
std::optional<WitnessMap> written_out(const GroundMap& map, Expander& expander, const WitnessSearch& choice,
                                      std::vector<std::string> names) {
    const std::size_t symbols = names.size();
    for (std::string& variable : names_of_variables(map)) names.push_back(std::move(variable));
    const auto exponents = monomials(map.directions);
    std::vector<SparsePolynomial> terms;
    for (std::size_t i = 0; i < exponents.size(); ++i) {
        const Fraction coefficient = expander(map.coefficients[i]);
        if (!coefficient.denominator.empty()) return std::nullopt;
        std::vector<std::size_t> shifted(symbols, 0);
        shifted.insert(shifted.end(), exponents[i].begin(), exponents[i].end());
        terms.push_back(with_values(coefficient.numerator, choice) * SparsePolynomial::term(1, shifted));
    }
    return WitnessMap{map.name, to_text(sum(terms), names), map.directions};
}

/// The numerator of a side over its denominator.
std::string side_text(Expander& expander, NodeId side, const WitnessSearch& choice,
                      const std::vector<std::string>& names) {
    const Fraction fraction = expander(side);
    const auto text_of = [&](const SparsePolynomial& polynomial) {
        return to_text(with_values(polynomial, choice), names);
    };
    if (fraction.denominator.empty()) return text_of(fraction.numerator);
    std::string text = "(" + text_of(fraction.numerator) + ")";
    for (const auto& [factor, exponent] : fraction.denominator) {
        text += "/(" + text_of(expander.field().factors()[factor]) + ")";
        if (exponent > 1) text += "^" + std::to_string(exponent);
    }
    return text;
}

}  // namespace

Witness find_counterexample(const GroundBlock& block, const Relation& relation, Expander& expander,
                            std::span<const Substitution> steps, const SparsePolynomial& difference,
                            const std::vector<SparsePolynomial>& nonzero) {
    std::vector<SparsePolynomial> required = nonzero;
    required.insert(required.begin(), difference);
    constexpr std::size_t most_attempts = 5;
    std::optional<WitnessSearch> choice;
    for (std::size_t attempt = 0; attempt < most_attempts; ++attempt) {
        WitnessSearch next(block, steps, required);
        const bool rational = next.choose(attempt);
        if (!rational && !next.is_witness()) continue;
        if (rational || !choice) choice.emplace(std::move(next));
        if (rational) break;
    }
    if (!choice) {
        throw Error(
            ErrorCode::limit_exceeded,
            "the sides differ, but no small values of the variables show it where the hypotheses have roots",
            {}, relation.offset);
    }
    std::vector<std::string> names;
    names.reserve(block.symbols.size());
    for (const Symbol& symbol : block.symbols) names.push_back(symbol.name);
    Witness witness;
    Counterexample& result = witness.counterexample;
    result.parameters = block.parameters;
    result.parameters.insert(result.parameters.end(), relation.parameters.begin(), relation.parameters.end());
    const std::set<NodeId> nodes = nodes_of_case(block, relation);
    std::set<std::size_t> maps;
    std::set<std::size_t> symbols;
    for (const NodeId id : nodes) {
        const Node& node = block.nodes[id];
        if (node.kind == NodeKind::application) maps.insert(block.applications[node.index].map);
        if (node.kind == NodeKind::symbol && !block.symbols[node.index].is_coefficient &&
            !block.symbols[node.index].is_bound) {
            symbols.insert(node.index);
        }
    }
    for (std::size_t i = 0; i < block.symbols.size(); ++i) {
        if (choice->is_root(i)) {
            witness.algebraic.push_back(names[i]);
        } else if (!block.symbols[i].is_bound) {
            witness.values.emplace_back(names[i], choice->values()[i]);
        }
    }
    for (const std::size_t symbol : symbols) {
        if (!choice->is_root(symbol)) result.variables.emplace_back(names[symbol], choice->values()[symbol]);
    }
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (choice->is_root(steps[i].symbol))
            result.roots.push_back(to_text(choice->relations()[i], names) + " == 0");
    }
    if (!choice->algebraic().empty()) {
        for (const std::size_t map : maps) {
            if (!block.maps[map].barycentric.empty()) continue;
            if (auto written = written_out(block.maps[map], expander, *choice, names))
                result.maps.push_back(std::move(*written));
        }
        result.left = side_text(expander, relation.left, *choice, names);
        result.right = side_text(expander, relation.right, *choice, names);
        return witness;
    }
    Evaluator evaluate(block, choice->values());
    result.left = to_string(evaluate(relation.left));
    result.right = to_string(evaluate(relation.right));
    if (result.left == result.right) {
        throw Error(ErrorCode::internal, "the counterexample found is none: this is an error of the program",
                    {}, relation.offset);
    }
    for (const std::size_t map : maps) {
        if (block.maps[map].barycentric.empty())
            result.maps.push_back(written_out(block.maps[map], evaluate));
    }
    std::set<std::string> listed;
    for (const NodeId id : nodes_below(block, {relation.left, relation.right})) {
        if (block.nodes[id].kind != NodeKind::application) continue;
        const GroundMap& map = block.maps[block.applications[block.nodes[id].index].map];
        if (!map.barycentric.empty()) continue;
        WitnessValue value = written_out(block, id, result.maps, evaluate);
        if (listed.insert(value.text).second) result.values.push_back(std::move(value));
    }
    return witness;
}

}  // namespace blossom::proofs
