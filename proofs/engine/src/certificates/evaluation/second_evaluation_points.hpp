#pragma once

#include "second_evaluation_class.hpp"

#include <blossom/rational/number_text.hpp>

#include <algorithm>

namespace blossom::proofs::second {

template <class Field>
typename Evaluation<Field>::Geometric Evaluation<Field>::point_of_number(Element coordinate) {
    Geometric point{{}, one(), true};
    point.coordinates.push_back(std::move(coordinate));
    return point;
}

template <class Field>
typename Evaluation<Field>::Geometric Evaluation<Field>::geometric(NodeId id, Scope& scope) {
    const Node& node = reading_.node(id);
    if (node.kind != Kind::geometric) return point_of_number(number(id, scope));
    const WorkLimit::Level level(counting_.work());
    return geometric_of_form(node, scope);
}

template <class Field>
typename Evaluation<Field>::Geometric Evaluation<Field>::geometric_of_form(const Node& node, Scope& scope) {
    switch (node.form) {
        case Form::unit_vector:
            return {{one()}, zero(), false};
        case Form::pair: {
            Element coordinate = number(node.children[0], scope);
            return {{std::move(coordinate)}, number(node.children[1], scope), false};
        }
        case Form::tuple: {
            Geometric point{{}, one(), true};
            for (const NodeId child : node.children) point.coordinates.push_back(number(child, scope));
            return point;
        }
        case Form::negation:
            return scaled(geometric(node.children[0], scope), field_.number(Rational(-1)));
        case Form::terms:
            return geometric_terms(node, scope);
        case Form::factors:
            return geometric_factors(node, scope);
        case Form::sum:
        case Form::mean:
            return geometric_iteration(node, scope);
        case Form::choice:
            return geometric(node.children[counting_.holds(node.children[0], scope) ? 1 : 2], scope);
        case Form::name:
        case Form::member:
            break;
        default:
            fail(ErrorCode::wrong_kind, "a point or a vector is expected here", node.offset);
    }
    if (node.meaning == Meaning::local)
        return variables_[static_cast<std::size_t>(scope[node.target].integer)];
    Value value = member(node, counting_.integers(node.children, scope));
    if (Geometric* found = std::get_if<Geometric>(&value)) return std::move(*found);
    fail(ErrorCode::wrong_kind, quoted(reading_.name(node.text)) + " is no point or vector here",
         node.offset);
}

template <class Field>
typename Evaluation<Field>::Geometric Evaluation<Field>::scaled(Geometric value, const Element& factor) {
    for (Element& coordinate : value.coordinates) coordinate = field_.product(coordinate, factor);
    value.mass = field_.product(value.mass, factor);
    value.unit_mass = false;
    return value;
}

template <class Field>
void Evaluation<Field>::add_to(Geometric& total, const Geometric& term, bool subtract, const Node& node) {
    if (total.coordinates.size() != term.coordinates.size()) {
        fail(ErrorCode::mismatched_dimensions,
             "values of the dimensions " + std::to_string(total.coordinates.size()) + " and " +
                 std::to_string(term.coordinates.size()) + " are added",
             node.offset);
    }
    const auto combine = [&](Element& to, const Element& from) {
        to = field_.sum(to, subtract ? field_.negative(from) : from);
    };
    for (std::size_t i = 0; i < term.coordinates.size(); ++i)
        combine(total.coordinates[i], term.coordinates[i]);
    combine(total.mass, term.mass);
    total.unit_mass = false;
}

template <class Field>
typename Evaluation<Field>::Geometric Evaluation<Field>::geometric_terms(const Node& node, Scope& scope) {
    const auto is_geometric = [&](NodeId child) { return reading_.node(child).kind == Kind::geometric; };
    if (is_geometric(node.children[0])) {
        Geometric total = geometric(node.children[0], scope);
        for (std::size_t i = 1; i < node.children.size(); ++i)
            add_to(total, geometric(node.children[i], scope), node.flags[i], node);
        return total;
    }
    // From left to right: the numbers before the first vector or pair are one number, and therefore one
    // point.
    Element number_in_front = number(node.children[0], scope);
    std::size_t i = 1;
    for (; !is_geometric(node.children[i]); ++i) {
        const Element next = number(node.children[i], scope);
        number_in_front =
            node.flags[i] ? difference(number_in_front, next) : field_.sum(number_in_front, next);
    }
    Geometric total = point_of_number(std::move(number_in_front));
    for (; i < node.children.size(); ++i)
        add_to(total, geometric(node.children[i], scope), node.flags[i], node);
    return total;
}

template <class Field>
typename Evaluation<Field>::Geometric Evaluation<Field>::geometric_factors(const Node& node, Scope& scope) {
    std::optional<Geometric> value;
    Element factor = one();
    for (std::size_t i = 0; i < node.children.size(); ++i) {
        if (reading_.node(node.children[i]).kind == Kind::geometric) {
            value = geometric(node.children[i], scope);
            continue;
        }
        const Element next = number(node.children[i], scope);
        factor = node.flags[i] ? field_.quotient(factor, next) : field_.product(factor, next);
    }
    return scaled(std::move(*value), factor);
}

template <class Field>
typename Evaluation<Field>::Geometric Evaluation<Field>::geometric_iteration(const Node& node, Scope& scope) {
    std::optional<Geometric> total;
    long long members = 0;
    counting_.each(node.children[0], node.slot, scope, [&] {
        Geometric member = geometric(node.children[1], scope);
        total ? add_to(*total, member, false, node) : static_cast<void>(total = std::move(member));
        ++members;
    });
    if (node.form == Form::mean) {
        if (members == 0) fail(ErrorCode::division_by_zero, "a mean of nothing", node.offset);
        return scaled(std::move(*total), field_.number(Rational(1) / Rational(members)));
    }
    if (total) return std::move(*total);
    const std::size_t size = dimension(node.children[1], scope, 0).value_or(1);
    return {std::vector<Element>(size, zero()), zero(), false};
}

// From the syntax, because nothing can be evaluated for an empty sum. Abbreviations that use themselves give
// no information.
template <class Field>
std::optional<std::size_t> Evaluation<Field>::dimension(NodeId id, const Scope& scope, std::size_t depth) {
    const Node& node = reading_.node(id);
    counting_.work().step();
    if (node.kind != Kind::geometric || depth > reading_.limits().nesting) return std::nullopt;
    if (node.form == Form::unit_vector || node.form == Form::pair) return 1;
    if (node.form == Form::tuple) return node.children.size();
    if (node.meaning == Meaning::local) {
        return variables_[static_cast<std::size_t>(scope[node.target].integer)].coordinates.size();
    }
    if (node.meaning == Meaning::declared) {
        return counting_.dimension(reading_.declarations()[node.target]);
    }
    if (node.meaning == Meaning::abbreviation) {
        const Abbreviation& let = reading_.abbreviations()[node.target];
        if (let.declaration) return counting_.dimension(reading_.declarations()[*let.declaration]);
        if (std::ranges::find(dimensions_in_work_, node.target) != dimensions_in_work_.end())
            return std::nullopt;
        dimensions_in_work_.push_back(node.target);
        const AtEnd forget([&] { dimensions_in_work_.pop_back(); });
        std::optional<std::size_t> found;
        for (const Clause& clause : let.clauses) {
            if (!found) found = dimension(clause.body, scope, depth + 1);
        }
        return found;
    }
    for (const NodeId child : node.children) {
        if (const auto found = dimension(child, scope, depth + 1)) return found;
    }
    return std::nullopt;
}

template <class Field>
typename Evaluation<Field>::Value Evaluation<Field>::member(const Node& node, const Key& indices) {
    if (node.may_be_bound) {
        Key key = indices;
        key.push_back(static_cast<long long>(node.text));
        const auto bound = bound_members_.find(key);
        if (bound != bound_members_.end()) {
            const Geometric& value = variables_[bound->second];
            if (node.kind == Kind::geometric) return value;
            return value.coordinates.front();
        }
    }
    if (node.meaning == Meaning::abbreviation) return abbreviation(node, indices);
    if (node.meaning == Meaning::declared) return declared_member(node, node.target, indices);
    if (node.meaning == Meaning::parameter)
        return field_.number(Rational(counting_.parameters()[node.target]));
    return symbol(node.text, indices);
}

template <class Field>
typename Evaluation<Field>::Value Evaluation<Field>::declared_member(const Node& node,
                                                                     std::uint32_t declaration,
                                                                     const Key& indices) {
    const Declaration& declared = reading_.declarations()[declaration];
    const std::string& family = reading_.name(node.text);
    const bool is_member = node.form != Form::name;
    if (is_member && reading_.strict() && !counting_.is_declared(declared, indices)) {
        fail(ErrorCode::syntax, name_of_member(family, indices) + " is not declared", node.offset);
    }
    if (declared.kind == Declaration::Kind::number) return symbol(node.text, indices);
    Key key = indices;
    key.push_back(static_cast<long long>(node.text));
    if (const Geometric* value = variable(key)) return *value;
    const auto known = points_.find(key);
    if (known != points_.end()) return known->second;
    return points_
        .emplace(std::move(key),
                 declared_value(declared, is_member ? name_of_member(family, indices) : family))
        .first->second;
}

template <class Field>
typename Evaluation<Field>::Geometric Evaluation<Field>::declared_value(const Declaration& declaration,
                                                                        const std::string& name) {
    const std::size_t size = counting_.dimension(declaration);
    if (declaration.kind == Declaration::Kind::frame) {
        if (declaration.frame_size != size + 1) {
            fail(ErrorCode::wrong_arity, "a frame has one point more than the dimension", declaration.offset);
        }
        Geometric point{std::vector<Element>(size, zero()), one(), true};
        if (declaration.place > 0) point.coordinates[declaration.place - 1] = one();
        return point;
    }
    const bool is_point = declaration.kind == Declaration::Kind::point;
    Geometric value{{}, is_point ? one() : zero(), is_point};
    for (std::size_t i = 1; i <= size; ++i) {
        const std::string text = name + "." + std::to_string(i);
        value.coordinates.push_back(field_.symbol(text));
    }
    return value;
}

template <class Field>
typename Evaluation<Field>::Value Evaluation<Field>::abbreviation(const Node& node, const Key& indices) {
    const Abbreviation& let = reading_.abbreviations()[node.target];
    Key key = indices;
    key.push_back(static_cast<long long>(node.target));
    const auto known = known_.back().abbreviations.find(key);
    if (known != known_.back().abbreviations.end()) return known->second;
    Scope inner;
    const Clause* clause = counting_.fitting_clause(node.target, indices, inner);
    const std::string& family = reading_.name(let.name);
    if (clause == nullptr) {
        if (let.declaration) return declared_member(node, *let.declaration, indices);
        if (counting_.needs_clause(node.target, indices.size()) || reading_.strict()) {
            fail(ErrorCode::syntax, "no line \"let\" fits " + name_of_member(family, indices), node.offset);
        }
        if (let.kind == Kind::geometric) {
            fail(ErrorCode::wrong_kind, name_of_member(family, indices) + " is a number, others are points",
                 node.offset);
        }
        return symbol(node.text, indices);
    }
    if (!abbreviations_in_work_.insert(key).second) {
        fail(ErrorCode::syntax,
             (let.bare ? family : name_of_member(family, indices)) + " is an abbreviation of itself",
             node.offset);
    }
    const AtEnd forget([&] { abbreviations_in_work_.erase(key); });
    counting_.work().require_few_abbreviations(abbreviations_in_work_.size());
    Value value = let.kind == Kind::geometric ? Value(geometric(clause->body, inner))
                                              : Value(number(clause->body, inner));
    return known_.back().abbreviations.emplace(key, std::move(value)).first->second;
}

template <class Field>
typename Field::Element Evaluation<Field>::symbol(std::uint32_t name, const Key& indices) {
    Key key = indices;
    key.push_back(static_cast<long long>(name));
    if (const Geometric* value = variable(key)) return value->coordinates.front();
    const auto known = symbols_.find(key);
    if (known != symbols_.end()) return known->second;
    const std::string& text = reading_.name(name);
    return symbols_
        .emplace(std::move(key), field_.symbol(indices.empty() ? text : name_of_member(text, indices)))
        .first->second;
}

}  // namespace blossom::proofs::second
