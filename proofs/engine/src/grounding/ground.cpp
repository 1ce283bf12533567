#include <blossom/proofs/ground.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <functional>

#include "grounder.hpp"

namespace blossom::proofs {

namespace {

/// Calls `action` with every choice of values of the ranges from range `i` on.
void for_each_choice(Grounder& grounder, const std::vector<const Range*>& ranges, std::size_t i,
                     Parameters& chosen, const std::function<void(const Parameters&)>& action) {
    if (i == ranges.size()) {
        action(chosen);
        return;
    }
    const Range& range = *ranges[i];
    for (const long long value : grounder.interval(range.first, range.last)) {
        const Grounder::Binding binding(grounder, range.name, value);
        chosen.emplace_back(range.name, value);
        for_each_choice(grounder, ranges, i + 1, chosen, action);
        chosen.pop_back();
    }
}

std::vector<const Range*> pointers(const std::vector<Range>& ranges) {
    std::vector<const Range*> result;
    result.reserve(ranges.size());
    for (const Range& range : ranges) result.push_back(&range);
    return result;
}

/// The relations of a line, one for each choice of its own ranges.
void add_relations(Grounder& grounder, const Statement& statement, std::size_t number,
                   std::vector<Relation> GroundBlock::* list) {
    Parameters chosen;
    for_each_choice(grounder, pointers(statement.ranges), 0, chosen, [&](const Parameters& choice) {
        auto& relations = grounder.block().*list;
        require_within(relations.size() + 1, grounder.limits().expansion_terms, "expansion_terms",
                       "the number of cases of one line, up to");
        Relation relation = grounder.relation(statement);
        relation.statement = number;
        relation.parameters = choice;
        relations.push_back(std::move(relation));
    });
}

/// Adds the claims of a line. An error in one choice of its ranges belongs to that choice.
void add_claims(Grounder& grounder, const Statement& statement, std::size_t number) {
    Parameters chosen;
    for_each_choice(grounder, pointers(statement.ranges), 0, chosen, [&](const Parameters& choice) {
        auto& claims = grounder.block().claims;
        require_within(claims.size() + 1, grounder.limits().expansion_terms, "expansion_terms",
                       "the number of cases of one line, up to");
        Relation relation;
        try {
            const auto unfit = grounder.unfit().find(&statement);
            if (unfit != grounder.unfit().end()) throw Error(unfit->second);
            relation = grounder.relation(statement);
        } catch (const Error& error) {
            relation.offset = statement.offset;
            relation.error = error;
        }
        relation.statement = number;
        relation.parameters = choice;
        claims.push_back(std::move(relation));
    });
}

}  // namespace

std::vector<NodeId> operands_of(const GroundBlock& block, NodeId id) {
    const Node& node = block.nodes[id];
    std::vector<NodeId> operands = node.operands;
    if (node.kind != NodeKind::application) return operands;
    const Application& application = block.applications[node.index];
    for (const auto& list : application.arguments) {
        for (const NodeArgument& argument : list) {
            operands.insert(operands.end(), argument.coordinates.begin(), argument.coordinates.end());
            operands.push_back(argument.mass);
        }
    }
    for (const NodeArgument& place : application.places) {
        operands.insert(operands.end(), place.coordinates.begin(), place.coordinates.end());
    }
    const GroundMap& map = block.maps[application.map];
    operands.insert(operands.end(), map.coefficients.begin(), map.coefficients.end());
    operands.insert(operands.end(), map.conditions.begin(), map.conditions.end());
    return operands;
}

std::set<NodeId> nodes_below(const GroundBlock& block, std::vector<NodeId> roots) {
    std::set<NodeId> found;
    while (!roots.empty()) {
        const NodeId id = roots.back();
        roots.pop_back();
        if (!found.insert(id).second) continue;
        const std::vector<NodeId> operands = operands_of(block, id);
        roots.insert(roots.end(), operands.begin(), operands.end());
    }
    return found;
}

std::set<NodeId> divisors_below(const GroundBlock& block, const std::vector<NodeId>& roots) {
    std::set<NodeId> divisors;
    for (const NodeId id : nodes_below(block, roots)) {
        const Node& node = block.nodes[id];
        if (node.kind == NodeKind::quotient) divisors.insert(node.operands[1]);
        if (node.kind != NodeKind::application) continue;
        const auto& conditions = block.maps[block.applications[node.index].map].conditions;
        divisors.insert(conditions.begin(), conditions.end());
    }
    return divisors;
}

std::vector<Parameters> parameter_choices(const Block& block, const Limits& limits) {
    Grounder grounder(limits);
    std::vector<const Range*> ranges;
    for (const Statement& statement : block.statements) {
        if (statement.kind != StatementKind::parameter) continue;
        const Range& range = statement.ranges.front();
        const auto same = [&](const Range* other) { return other->name == range.name; };
        if (std::ranges::any_of(ranges, same))
            refuse(quoted(range.name) + " is declared already", range.offset);
        ranges.push_back(&range);
    }
    std::vector<Parameters> choices;
    Parameters chosen;
    for_each_choice(grounder, ranges, 0, chosen, [&](const Parameters& choice) {
        require_elements(choices.size() + 1, limits, ranges.empty() ? block.offset : ranges.front()->offset);
        choices.push_back(choice);
    });
    return choices;
}

std::set<std::size_t> unfit_claims(const Block& block, const Parameters& parameters, const Limits& limits) {
    Grounder grounder(limits);
    for (const auto& [name, value] : parameters) grounder.bind(name, value);
    grounder.begin(block);
    std::set<std::size_t> numbers;
    for (std::size_t i = 0; i < block.statements.size(); ++i) {
        if (grounder.unfit().contains(&block.statements[i])) numbers.insert(i);
    }
    return numbers;
}

GroundBlock ground(const Block& block, const Parameters& parameters, const Limits& limits) {
    Grounder grounder(limits);
    for (const auto& [name, value] : parameters) grounder.bind(name, value);
    grounder.begin(block);
    grounder.block().parameters = parameters;
    for (std::size_t i = 0; i < block.statements.size(); ++i) {
        const Statement& statement = block.statements[i];
        switch (statement.kind) {
            case StatementKind::map:
                grounder.declare_map(statement);
                break;
            case StatementKind::polynomial:
                grounder.declare_polynomial(statement);
                break;
            case StatementKind::raise:
                grounder.declare_raised(statement);
                break;
            case StatementKind::assume:
                add_relations(grounder, statement, i, &GroundBlock::assumptions);
                break;
            case StatementKind::given:
                add_relations(grounder, statement, i, &GroundBlock::hypotheses);
                break;
            case StatementKind::claim:
            case StatementKind::refute:
                add_claims(grounder, statement, i);
                break;
            default:
                break;
        }
    }
    return std::move(grounder.block());
}

}  // namespace blossom::proofs
