#include <blossom/proofs/ground.hpp>
#include <blossom/rational/error.hpp>

#include <functional>

#include "grounder.hpp"

namespace blossom::proofs {

namespace {

using Choice = std::vector<std::pair<std::string, long long>>;

/// Calls `action` with every choice of values of the ranges from number `i` on.
void for_each_choice(Grounder& grounder, const std::vector<const Range*>& ranges, std::size_t i,
                     Choice& chosen, const std::function<void(const Choice&)>& action) {
    if (i == ranges.size()) {
        action(chosen);
        return;
    }
    const Range& range = *ranges[i];
    if (grounder.bound(range.name)) {
        throw Error(ErrorCode::syntax, "\"" + range.name + "\" is declared already", "", range.offset);
    }
    for (const long long value : grounder.interval(range.first, range.last)) {
        grounder.bind(range.name, value);
        chosen.emplace_back(range.name, value);
        for_each_choice(grounder, ranges, i + 1, chosen, action);
        chosen.pop_back();
        grounder.unbind(range.name);
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
    Choice chosen;
    for_each_choice(grounder, pointers(statement.ranges), 0, chosen, [&](const Choice& choice) {
        Relation relation{grounder.scalar(statement.sides[0]),
                          grounder.scalar(statement.sides[1]),
                          number,
                          statement.offset,
                          {},
                          choice};
        for (const Expression& quantified : statement.quantified) {
            for (const Expression& name : grounder.members(quantified))
                relation.quantified.push_back(grounder.scalar_symbol(name));
        }
        auto& relations = grounder.block().*list;
        require_within(relations.size() + 1, grounder.limits().expansion_terms, "expansion_terms",
                       "the number of cases of one line, up to");
        relations.push_back(std::move(relation));
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
    const auto& coefficients = block.maps[application.map].coefficients;
    operands.insert(operands.end(), coefficients.begin(), coefficients.end());
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

std::vector<Choice> parameter_choices(const Block& block, const Limits& limits) {
    Grounder grounder(limits);
    std::vector<const Range*> ranges;
    for (const Statement& statement : block.statements) {
        if (statement.kind == StatementKind::parameter) ranges.push_back(&statement.ranges.front());
    }
    std::vector<Choice> choices;
    Choice chosen;
    for_each_choice(grounder, ranges, 0, chosen, [&](const Choice& choice) {
        if (choices.size() == limits.expansion_terms) {
            throw Error(ErrorCode::limit_exceeded,
                        "the number of cases exceeds the limit expansion_terms = " +
                            std::to_string(limits.expansion_terms),
                        "", ranges.empty() ? block.offset : ranges.front()->offset);
        }
        choices.push_back(choice);
    });
    return choices;
}

GroundBlock ground(const Block& block, const Choice& parameters, const Limits& limits) {
    Grounder grounder(limits);
    for (const auto& [name, value] : parameters) grounder.bind(name, value);
    grounder.finish_parameters();
    grounder.block().parameters = parameters;
    for (std::size_t i = 0; i < block.statements.size(); ++i) {
        const Statement& statement = block.statements[i];
        switch (statement.kind) {
            case StatementKind::parameter:
                break;
            case StatementKind::map:
                grounder.declare_map(statement);
                break;
            case StatementKind::point:
            case StatementKind::vector:
                grounder.declare_points(statement);
                break;
            case StatementKind::polynomial:
                grounder.declare_polynomial(statement);
                break;
            case StatementKind::raise:
                grounder.declare_raised(statement);
                break;
            case StatementKind::let:
                grounder.declare_let(statement);
                break;
            case StatementKind::assume:
                add_relations(grounder, statement, i, &GroundBlock::assumptions);
                break;
            case StatementKind::given:
                add_relations(grounder, statement, i, &GroundBlock::hypotheses);
                break;
            default:
                add_relations(grounder, statement, i, &GroundBlock::claims);
        }
    }
    return std::move(grounder.block());
}

}  // namespace blossom::proofs
