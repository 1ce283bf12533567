#include "proof_certificate.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <map>

namespace blossom::cli {

namespace {

using proofs::GroundBlock;
using proofs::NodeId;
using proofs::NodeKind;

/// Nodes get new numbers, so that an entry holds only what it needs.
using Numbers = std::map<NodeId, std::size_t>;

Json argument_json(const proofs::NodeArgument& argument, const Numbers& numbers) {
    Json::Array entries;
    for (const NodeId coordinate : argument.coordinates) entries.emplace_back(numbers.at(coordinate));
    entries.emplace_back(numbers.at(argument.mass));
    return entries;
}

Json application_json(const proofs::Application& application, const Numbers& numbers) {
    Json::Array arguments;
    for (const auto& list : application.arguments) {
        Json::Array direction;
        for (const proofs::NodeArgument& argument : list)
            direction.push_back(argument_json(argument, numbers));
        arguments.emplace_back(std::move(direction));
    }
    if (application.polar) return Json::Array{"blossom", application.map, std::move(arguments)};
    Json::Array orders;
    for (const std::size_t order : application.orders) orders.emplace_back(order);
    return Json::Array{"value", application.map, std::move(orders), std::move(arguments)};
}

Json node_json(const GroundBlock& block, NodeId id, const Numbers& numbers) {
    const proofs::Node& node = block.nodes[id];
    Json::Array result;
    switch (node.kind) {
        case NodeKind::constant:
            return Json::Array{"constant", node.value};
        case NodeKind::symbol:
            return Json::Array{"symbol", node.index};
        case NodeKind::application:
            return application_json(block.applications[node.index], numbers);
        case NodeKind::sum:
            result.emplace_back("sum");
            break;
        case NodeKind::product:
            result.emplace_back("product");
            break;
        case NodeKind::quotient:
            result.emplace_back("quotient");
            break;
        case NodeKind::power:
            result.emplace_back("power");
    }
    for (const NodeId operand : node.operands) result.emplace_back(numbers.at(operand));
    if (node.kind == NodeKind::power) result.emplace_back(node.index);
    return result;
}

/// [["3/2", [symbol, exponent], ...], ...]
Json polynomial_json(const SparsePolynomial& polynomial) {
    Json::Array terms;
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        Json::Array term{polynomial.coefficient(i)};
        for (std::size_t j = 0; j < polynomial.variables(); ++j) {
            const std::size_t exponent = polynomial.exponent(i, j);
            if (exponent != 0) term.emplace_back(Json::Array{j, exponent});
        }
        terms.emplace_back(std::move(term));
    }
    return terms;
}

Json maps_json(const GroundBlock& block, const Numbers& numbers) {
    Json::Array maps;
    for (const proofs::GroundMap& map : block.maps) {
        Json::Array directions;
        for (const auto& [degree, dimension] : map.directions)
            directions.emplace_back(Json::Array{degree, dimension});
        Json::Array coefficients;
        for (const NodeId coefficient : map.coefficients) coefficients.emplace_back(numbers.at(coefficient));
        maps.emplace_back(Json::Object{{"name", map.name},
                                       {"directions", std::move(directions)},
                                       {"coefficients", std::move(coefficients)}});
    }
    return maps;
}

}  // namespace

Json certificate_entry(const proofs::ProvedCase& proved, const std::string& id,
                       const std::string& statement) {
    const GroundBlock& block = proved.block;
    std::vector<NodeId> roots{proved.relation.left, proved.relation.right};
    for (const proofs::Relation& hypothesis : block.hypotheses) {
        roots.push_back(hypothesis.left);
        roots.push_back(hypothesis.right);
    }
    for (const proofs::GroundMap& map : block.maps)
        roots.insert(roots.end(), map.coefficients.begin(), map.coefficients.end());
    Numbers numbers;
    Json::Array nodes;
    for (const NodeId node : proofs::nodes_below(block, roots)) {
        numbers.emplace(node, numbers.size());
        nodes.push_back(node_json(block, node, numbers));
    }
    Json::Object parameters;
    for (const auto& list : {block.parameters, proved.relation.parameters}) {
        for (const auto& [name, value] : list)
            parameters.emplace_back(name, Json::Number{std::to_string(value)});
    }
    Json::Array symbols;
    for (const proofs::Symbol& symbol : block.symbols) symbols.emplace_back(symbol.name);
    Json::Array hypotheses;
    for (const proofs::Relation& hypothesis : block.hypotheses) {
        Json::Array quantified;
        for (const std::size_t symbol : hypothesis.quantified) quantified.emplace_back(symbol);
        hypotheses.emplace_back(
            Json::Array{numbers.at(hypothesis.left), numbers.at(hypothesis.right), std::move(quantified)});
    }
    Json::Array solved;
    for (const std::size_t symbol : proved.solved) solved.emplace_back(symbol);
    Json::Array denominator;
    for (const auto& [factor, exponent] : proved.left.denominator)
        denominator.emplace_back(Json::Array{polynomial_json(proved.factors[factor]), exponent});
    return Json::Object{{"id", id},
                        {"statement", statement},
                        {"parameters", std::move(parameters)},
                        {"symbols", std::move(symbols)},
                        {"maps", maps_json(block, numbers)},
                        {"nodes", std::move(nodes)},
                        {"hypotheses", std::move(hypotheses)},
                        {"solved", std::move(solved)},
                        {"left", numbers.at(proved.relation.left)},
                        {"right", numbers.at(proved.relation.right)},
                        {"numerator", polynomial_json(proved.left.numerator)},
                        {"denominator", std::move(denominator)}};
}

std::string seal_of(const Json& entries) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : to_text(entries)) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3;
    }
    return fmt::format("{:016x}", hash);
}

Json sealed_certificate(Json::Array entries) {
    Json proofs(std::move(entries));
    const std::string seal = seal_of(proofs);
    return Json::Object{{"certificate", std::size_t{1}}, {"seal", seal}, {"proofs", std::move(proofs)}};
}

}  // namespace blossom::cli
