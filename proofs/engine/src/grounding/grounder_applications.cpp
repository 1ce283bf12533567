#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include "grounder.hpp"

/// Values, derivatives and blossoms of maps.

namespace blossom::proofs {

NodeArgument Grounder::argument(const Expression& e, std::size_t dimension) {
    NodeArgument result = as_argument(value(e));
    if (result.coordinates.size() != dimension) {
        refuse("an argument of dimension " + std::to_string(result.coordinates.size()) +
                   " found, expected one of dimension " + std::to_string(dimension),
               e.offset);
    }
    return result;
}

NodeArgument Grounder::placed(const NodeArgument& argument, const GroundMap& map) {
    if (map.barycentric.empty()) return argument;
    std::vector<NodeId> entries = argument.coordinates;
    entries.push_back(argument.mass);
    std::vector<NodeId> coordinates;
    for (const auto& row : map.barycentric) {
        std::vector<NodeId> summands;
        summands.reserve(row.size());
        for (std::size_t i = 0; i < row.size(); ++i) summands.push_back(multiply({row[i], entries[i]}));
        coordinates.push_back(add(std::move(summands)));
    }
    const NodeId first = coordinates.front();
    coordinates.erase(coordinates.begin());
    return {std::move(coordinates), first};
}

void Grounder::add_arguments(const Expression& e, const GroundMap& map, std::size_t direction,
                             std::vector<NodeArgument>& arguments) {
    const auto [degree, dimension] = map.directions[direction];
    if (e.kind == ExpressionKind::copies) {
        const std::size_t copies = count(e.children[1]);
        spend(copies, e.offset);
        arguments.insert(arguments.end(), copies, placed(argument(e.children[0], dimension), map));
    } else if (e.kind == ExpressionKind::run) {
        for (const Expression& member : run_members(e))
            arguments.push_back(placed(argument(member, dimension), map));
    } else if (e.kind == ExpressionKind::family) {
        for (const long long i : family_indices(e)) {
            const Binding binding(*this, e.name, i);
            arguments.push_back(placed(argument(e.children[0], dimension), map));
        }
    } else {
        arguments.push_back(placed(argument(e, dimension), map));
    }
}

NodeId Grounder::push(Application application) {
    const std::size_t offset = application.offset;
    block_.applications.push_back(std::move(application));
    return push({NodeKind::application, {}, block_.applications.size() - 1, {}, 0}, offset);
}

NodeId Grounder::application(const Expression& e) {
    if (const Permutation* chosen = permutation(e.name)) {
        const long long i = integer(e.groups[0][0]);
        if (i < 1 || static_cast<std::size_t>(i) > chosen->images.size()) {
            refuse(std::to_string(i) + " is not among 1.." + std::to_string(chosen->images.size()) +
                       ", which the permutation permutes",
                   e.groups[0][0].offset);
        }
        return constant(chosen->images[static_cast<std::size_t>(i) - 1]);
    }
    const auto found = maps_.find(e.name);
    if (found == maps_.end()) refuse("the map " + quoted(e.name) + " is declared below this line", e.offset);
    Application result;
    result.map = found->second;
    result.offset = e.offset;
    if (e.kind == ExpressionKind::blossom) return blossom(e, std::move(result));
    return e.children.empty() ? value_of(e, std::move(result)) : derivative_of(e, std::move(result));
}

NodeId Grounder::blossom(const Expression& e, Application result) {
    // A copy, because grounding an argument may add maps.
    const GroundMap map = block_.maps[result.map];
    result.form = Application::Form::blossom;
    for (std::size_t i = 0; i < map.directions.size(); ++i) {
        result.arguments.emplace_back();
        for (const Expression& given : e.groups[i]) add_arguments(given, map, i, result.arguments[i]);
        if (result.arguments[i].size() != map.directions[i].degree) {
            throw Error(ErrorCode::wrong_arity,
                        "the blossom of " + e.name + " takes " + std::to_string(map.directions[i].degree) +
                            " arguments, found " + std::to_string(result.arguments[i].size()),
                        {}, e.offset);
        }
    }
    return push(std::move(result));
}

/// The argument of a value or derivative: one per direction, or the coordinates of a point.
NodeArgument Grounder::place_of(const Expression& e, const GroundMap& map, std::size_t direction) {
    const auto& given = e.groups[0];
    const std::size_t dimension = map.directions[direction].dimension;
    if (given.size() == map.directions.size()) return argument(given[direction], dimension);
    NodeArgument point{{}, constant(1)};
    for (const Expression& coordinate : given) point.coordinates.push_back(scalar(coordinate));
    return point;
}

NodeId Grounder::value_of(const Expression& e, Application result) {
    const GroundMap map = block_.maps[result.map];
    for (std::size_t i = 0; i < map.directions.size(); ++i)
        result.arguments.push_back({placed(place_of(e, map, i), map)});
    return push(std::move(result));
}

/// n!/(n-k)! times the blossom of n - k copies of the point and k vectors: delta, or the given directions.
/// Source: Goldman, theorem 9. Statement: goldman-thm9.
NodeId Grounder::derivative_of(const Expression& e, Application result) {
    const GroundMap map = block_.maps[result.map];
    result.form = Application::Form::derivative;
    const bool by_directions = map.directions.size() == 1 && map.directions[0].dimension > 1;
    const bool differentiates =
        by_directions ||
        std::ranges::any_of(e.children, [&](const Expression& order) { return count(order) > 0; });
    if (!differentiates) {
        result.form = Application::Form::value;
        return value_of(e, std::move(result));
    }
    for (std::size_t i = 0; i < map.directions.size(); ++i) {
        const NodeArgument point = place_of(e, map, i);
        const std::size_t order = by_directions ? e.children.size() : count(e.children[i]);
        if (order > 0 && !is_one(point.mass))
            refuse("a derivative is taken at a number or at a point, of mass 1", e.offset);
        std::vector<NodeArgument> directions;
        if (by_directions) {
            for (const Expression& direction : e.children)
                directions.push_back(argument(direction, map.directions[i].dimension));
        } else {
            directions.assign(order, NodeArgument{{constant(1)}, constant(0)});
        }
        result.orders.push_back(order);
        result.places.push_back(point);
        // A derivative of an order above the degree is zero, but only defined where the value is.
        const std::size_t degree = map.directions[i].degree;
        const bool vanishes = order > degree;
        result.scale *= vanishes ? Rational(0) : Rational(falling_factorial(degree, order));
        result.arguments.emplace_back(vanishes ? degree : degree - order, placed(point, map));
        for (const NodeArgument& direction : directions) {
            if (!vanishes) result.arguments.back().push_back(placed(direction, map));
        }
    }
    return push(std::move(result));
}

}  // namespace blossom::proofs
