#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/core/curve/derivative.hpp>
#include <blossom/proofs/evaluation.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include "claims.hpp"
#include "symbols.hpp"

namespace blossom::worked {

namespace {

/// The numbers of the counterexample for the symbols of its case.
std::vector<Rational> values_of(const WrittenCase& written, const proofs::Counterexample& found) {
    std::vector<Rational> values(written.block.symbols.size());
    for (const auto& [name, value] : found.variables) {
        const auto symbol = std::ranges::find(written.block.symbols, name, &proofs::Symbol::name);
        values[static_cast<std::size_t>(symbol - written.block.symbols.begin())] = value;
    }
    for (const proofs::WitnessMap& witness : found.maps) {
        const Polynomial polynomial = parse_univariate(witness.text).polynomial;
        const auto map = std::ranges::find(written.block.maps, witness.name, &proofs::GroundMap::name);
        for (std::size_t k = 0; k < map->coefficients.size(); ++k) {
            const proofs::Node& node = written.block.nodes[map->coefficients[k]];
            if (node.kind == proofs::NodeKind::symbol && written.block.symbols[node.index].is_coefficient)
                values[node.index] = k <= polynomial.degree() ? polynomial[k] : Rational(0);
        }
    }
    return values;
}

/// The arguments of a blossom value with numbers.
std::vector<Argument> arguments_of(const proofs::Application& application, proofs::Evaluator& evaluate) {
    std::vector<Argument> arguments;
    for (const proofs::NodeArgument& argument : application.arguments.front()) {
        arguments.emplace_back(evaluate(argument.coordinates.front()), evaluate(argument.mass));
    }
    return arguments;
}

/// p(...) = sum c_k / C(n, k) e_k(...) = value, or without the sum for what is no blossom.
Formula value_equation(const Formula& name, const PolynomialCurve& curve, std::span<const Argument> arguments,
                       const Rational& value) {
    std::vector<Formula> sides{name};
    if (name.kind == FormulaKind::blossom && !arguments.empty()) {
        std::vector<Formula> terms;
        for (std::size_t k = 0; k <= curve.degree(); ++k) {
            const Rational weight = curve.coordinate(0)[k] / Rational(binomial(curve.degree(), k));
            const Formula e = elementary(k, argument_formulas(arguments));
            if (!weight.is_zero()) terms.push_back(combination({{weight, e}}));
        }
        sides.push_back(sum(std::move(terms)));
    }
    sides.push_back(number(value));
    return equation(std::move(sides));
}

/// A side, the same with numbers for its values, and the result.
void append_side(Blocks& step, const WrittenCase& written, std::span<const Rational> values,
                 const std::vector<proofs::NodeId>& applications, proofs::NodeId side) {
    GroundFormulas numbers(written.block, values);
    proofs::Evaluator evaluate(written.block, values);
    const auto below = proofs::nodes_below(written.block, {side});
    std::vector<Formula> equations;
    for (const proofs::NodeId node : applications) {
        if (!below.contains(node)) continue;
        const proofs::Application& application = written.block.applications[written.block.nodes[node].index];
        const proofs::GroundMap& map = written.block.maps[application.map];
        std::vector<Rational> coefficients;
        coefficients.reserve(map.coefficients.size());
        for (const proofs::NodeId coefficient : map.coefficients) {
            coefficients.push_back(evaluate(coefficient));
        }
        const PolynomialCurve curve(Polynomial(coefficients), map.directions.front().degree);
        const Formula value =
            value_equation(numbers(node), curve, arguments_of(application, evaluate), evaluate(node));
        if (std::ranges::find(equations, value) == equations.end()) equations.push_back(value);
    }
    const Formula whole = equation({numbers(side), number(evaluate(side))});
    if (std::ranges::find_if(equations, [&](const Formula& one) {
            return one.parts.front() == whole.parts.front();
        }) == equations.end()) {
        equations.push_back(whole);
    }
    step.show(std::move(equations));
}

/// The maps and numbers of the counterexample.
void append_counterexample(Document& document, const WrittenCase& written,
                           const proofs::Counterexample& found) {
    Blocks& step = document.step("The counterexample");
    const std::string variable = free_letter(written.block);
    std::vector<Formula> maps;
    for (const proofs::WitnessMap& witness : found.maps) {
        const std::size_t degree = witness.directions.front().degree;
        const PolynomialCurve curve(parse_univariate(witness.text).polynomial, degree);
        document.maps.push_back({witness.name, witness.name, variable, PolynomialMap(curve)});
        maps.push_back(equation(
            {call(witness.name, {symbol(variable)}), polynomial_formula(curve.coordinate(0), variable)}));
    }
    if (!maps.empty())
        step.say("Among the simplest maps for which the two sides differ:").show(std::move(maps));
    GroundFormulas formulas(written.block);
    std::vector<Formula> numbers;
    for (const auto& [name, value] : found.variables) {
        const auto symbol = std::ranges::find(written.block.symbols, name, &proofs::Symbol::name);
        const auto i = static_cast<std::size_t>(symbol - written.block.symbols.begin());
        numbers.push_back(equation({formulas.symbol_formula(i), number(value)}));
    }
    if (!numbers.empty()) step.say("with").show(std::move(numbers));
}

/// A side with its value; an expression in variables without a rational value is unchanged.
Formula side_formula(const proofs::Counterexample& found, const std::string& side) {
    return found.roots.empty() ? number(parse_rational(side)) : symbol(side);
}

/// The counterexample in words, for maps whose values are not written.
Table counterexample_table(const proofs::Counterexample& found) {
    Table table{"What makes the two sides differ.", {"what", "value"}, {}};
    for (const proofs::WitnessMap& map : found.maps) {
        table.rows.push_back({Cell(map.name.c_str()), Cell(map.text.c_str())});
    }
    for (const auto& [name, value] : found.variables) {
        table.rows.push_back({Cell(name.c_str()), Cell(to_string(value).c_str())});
    }
    for (const proofs::WitnessValue& value : found.values) {
        const std::size_t sign = value.text.rfind(" = ");
        table.rows.push_back(
            {Cell(value.text.substr(0, sign).c_str()), Cell(value.text.substr(sign + 3).c_str())});
    }
    return table;
}

}  // namespace

void append_refutation(Document& document, const DecidedClaim& claim,
                       const std::optional<WrittenCase>& written, const Limits& limits) {
    static_cast<void>(limits);
    const proofs::Counterexample& found = *claim.decision.counterexample();
    const Formula left_value = side_formula(found, found.left);
    const Formula right_value = side_formula(found, found.right);
    const Formula differ = relation("≠", {left_value, right_value});
    if (written && found.roots.empty()) {
        const std::vector<Rational> values = values_of(*written, found);
        const std::vector<proofs::NodeId> applications = applications_of(*written);
        append_counterexample(document, *written, found);
        append_side(document.step("The left side"), *written, values, applications, written->relation.left);
        append_side(document.step("The right side"), *written, values, applications, written->relation.right);
        GroundFormulas numbers(written->block, values);
        document.result.show(
            {relation("≠", {numbers(written->relation.left), numbers(written->relation.right)})});
    } else {
        document.step("The counterexample").add(counterexample_table(found));
    }
    document.result.say({"The sides are ", left_value, " and ", right_value, ": the claim does not hold."});
    Blocks again{Paragraph{"Both sides were computed anew with these numbers, and differ:"},
                 Display{{differ}}};
    Table commands{"Every value can be computed again with these commands.", {"value", "command"}, {}};
    for (const proofs::WitnessValue& value : found.values) {
        if (!value.command.empty())
            commands.rows.push_back({Cell(value.text.c_str()), Cell(value.command.c_str())});
    }
    if (!commands.rows.empty()) again.add(std::move(commands));
    document.check = {std::move(again), found.left != found.right, "The claim is refuted."};
}

}  // namespace blossom::worked
