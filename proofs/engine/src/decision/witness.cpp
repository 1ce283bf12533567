#include "witness.hpp"

#include <blossom/core/polynomial_text.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <ranges>
#include <set>

#include <blossom/proofs/evaluation.hpp>

namespace blossom::proofs {

namespace {

SparsePolynomial specialised(const SparsePolynomial& polynomial, std::size_t variable,
                             const Rational& value) {
    if (polynomial.degree_in(variable) == 0) return polynomial;
    const auto powers = coefficients_in(polynomial, variable);
    if (value.is_zero()) return powers.front();
    std::vector<SparsePolynomial> summands;
    summands.reserve(powers.size());
    for (std::size_t k = 0; k < powers.size(); ++k) {
        summands.push_back(powers[k] * SparsePolynomial(pow(value, k)));
    }
    return sum(summands);
}

/// 0, 1, -1, 2, -2, ...
Rational small_integer(std::size_t number) {
    const auto half = static_cast<long long>((number + 1) / 2);
    return number % 2 == 1 ? half : -half;
}

/// The free symbols in the order in which they get their values.
std::vector<std::size_t> order_of_symbols(const GroundBlock& block, const Elimination& elimination) {
    std::vector<std::size_t> order;
    for (std::size_t i = block.symbols.size(); i-- > 0;) {
        if (block.symbols[i].is_coefficient) order.push_back(i);
    }
    for (std::size_t i = 0; i < block.symbols.size(); ++i) {
        if (!block.symbols[i].is_coefficient) order.push_back(i);
    }
    for (const auto& solution : elimination.solutions()) std::erase(order, solution.symbol);
    return order;
}

std::vector<Rational> find_values(const GroundBlock& block, std::vector<SparsePolynomial> nonzero,
                                  const Elimination& elimination) {
    std::vector<Rational> values(block.symbols.size());
    for (const std::size_t symbol : order_of_symbols(block, elimination)) {
        // Each polynomial rules out no more values than it has degree.
        for (std::size_t number = 0;; ++number) {
            std::vector<SparsePolynomial> left;
            for (const SparsePolynomial& polynomial : nonzero) {
                left.push_back(specialised(polynomial, symbol, small_integer(number)));
                if (left.back().is_zero()) break;
            }
            if (!left.empty() && left.back().is_zero()) continue;
            values[symbol] = small_integer(number);
            nonzero = std::move(left);
            break;
        }
    }
    const auto& solutions = elimination.solutions();
    for (const auto& solution : std::ranges::reverse_view(solutions)) {
        values[solution.symbol] = solution.numerator(values) / solution.denominator(values);
    }
    return values;
}

WitnessMap written_out(const GroundMap& map, Evaluator& evaluate) {
    std::vector<std::string> names;
    std::size_t variables = 0;
    for (const Direction& direction : map.directions) variables += direction.dimension;
    if (variables == 1) {
        names = {"t"};
    } else if (map.directions.size() == 2 && variables == 2) {
        names = {"u", "v"};
    } else {
        names = numbered_names("x", variables);
    }
    const auto exponents = monomials(map.directions);
    std::vector<SparsePolynomial> terms;
    terms.reserve(exponents.size());
    for (std::size_t i = 0; i < exponents.size(); ++i) {
        terms.push_back(SparsePolynomial::term(evaluate(map.coefficients[i]), exponents[i]));
    }
    return {map.name, to_text(sum(terms), names), map.directions};
}

struct WrittenArgument {
    std::string readable;
    std::string option;  ///< as --at takes it
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

/// The value of one application, and the command that computes it, for maps of one variable.
WitnessValue written_out(const GroundBlock& block, NodeId id, const std::vector<WitnessMap>& maps,
                         Evaluator& evaluate) {
    const Application& application = block.applications[block.nodes[id].index];
    const WitnessMap& map = *std::ranges::find(maps, block.maps[application.map].name, &WitnessMap::name);
    std::string readable;
    std::string options;
    bool has_command = map.directions.size() == 1 && map.directions[0].dimension == 1;
    for (const auto& list : application.arguments) {
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
    const bool derivative = std::ranges::any_of(application.orders, [](std::size_t k) { return k != 0; });
    if (derivative) name = "D(" + map.name + ", " + order + ")";
    WitnessValue result{application.polar ? name + "[" + readable + "]" : name + "(" + readable + ")", ""};
    result.text += " = " + to_string(evaluate(id));
    const bool plain = application.polar || options.find(':') == std::string::npos;
    if (has_command && plain && !options.empty()) {
        result.command = std::string("blossom ") +
                         (application.polar ? "blossom"
                          : derivative      ? "derivative"
                                            : "evaluate") +
                         " \"" + map.text + "\" --degree " + std::to_string(map.directions[0].degree) +
                         (derivative ? " --order " + order : "") + " --at " + options;
    }
    return result;
}

}  // namespace

Counterexample find_counterexample(const GroundBlock& block, const Relation& relation,
                                   SparsePolynomial difference, std::vector<SparsePolynomial> conditions,
                                   const Elimination& elimination) {
    conditions.insert(conditions.begin(), std::move(difference));
    const std::vector<Rational> values = find_values(block, std::move(conditions), elimination);
    Evaluator evaluate(block, values);
    Counterexample result;
    result.parameters = block.parameters;
    result.parameters.insert(result.parameters.end(), relation.parameters.begin(), relation.parameters.end());
    result.left = evaluate(relation.left);
    result.right = evaluate(relation.right);
    if (result.left == result.right) {
        throw Error(ErrorCode::internal, "the counterexample found is none: this is an error of the program",
                    "", relation.offset);
    }
    std::set<std::size_t> maps;
    std::set<std::size_t> symbols;
    const std::set<NodeId> nodes = nodes_below(block, {relation.left, relation.right});
    for (const NodeId id : nodes) {
        const Node& node = block.nodes[id];
        if (node.kind == NodeKind::application) maps.insert(block.applications[node.index].map);
        if (node.kind == NodeKind::symbol && !block.symbols[node.index].is_coefficient)
            symbols.insert(node.index);
    }
    for (const std::size_t map : maps) result.maps.push_back(written_out(block.maps[map], evaluate));
    for (const std::size_t symbol : symbols) {
        result.variables.emplace_back(block.symbols[symbol].name, values[symbol]);
    }
    std::set<std::string> listed;
    for (const NodeId id : nodes) {
        if (block.nodes[id].kind != NodeKind::application) continue;
        WitnessValue value = written_out(block, id, result.maps, evaluate);
        if (listed.insert(value.text).second) result.values.push_back(std::move(value));
    }
    return result;
}

}  // namespace blossom::proofs
