#pragma once

#include "second_evaluation_class.hpp"

#include <blossom/rational/combinatorics.hpp>

namespace blossom::proofs::second {

template <class Field>
typename Field::Element Evaluation<Field>::map_derivative(const Node& node, Scope& scope) {
    const MapShape& own = shape(node.target);
    const std::size_t order_count = node.groups.front();
    if (own.directions.size() == 1 && own.directions.front().dimension > 1)
        return directional_derivative(node, scope);
    if (order_count != own.directions.size()) {
        fail(ErrorCode::wrong_arity, "a derivative has one order a direction", node.offset);
    }
    const std::vector<Geometric> arguments = map_arguments(node, order_count, scope);
    std::vector<std::vector<Element>> weights;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (reading_.node(node.children[i]).kind > Kind::possible_integer) {
            fail(ErrorCode::wrong_kind, "an order of differentiation is an integer", node.offset);
        }
        const std::size_t order =
            counting_.count(node.children[i], scope, reading_.limits().degree, "an order of differentiation");
        weights.push_back(derivative_weights(own.directions[i], arguments[i], order, node.offset));
    }
    return contract(node.target, weights);
}

template <class Field>
std::vector<typename Field::Element> Evaluation<Field>::derivative_weights(const Direction& direction,
                                                                           const Geometric& at,
                                                                           std::size_t order,
                                                                           std::size_t offset) {
    require_dimension(at, 1, offset);
    if (!has_unit_mass(at)) {
        fail(ErrorCode::wrong_kind, "a derivative is taken at a number or at a point of mass 1", offset);
    }
    counting_.work().step(direction.monomials.size());
    std::vector<Element> weights;
    Element power = one();
    for (std::size_t exponent = 0; exponent <= direction.degree; ++exponent) {
        if (exponent < order) {
            weights.push_back(zero());
            continue;
        }
        weights.push_back(field_.product(field_.number(Rational(falling_factorial(exponent, order))), power));
        power = field_.product(power, at.coordinates.front());
    }
    return weights;
}

// By definition: d/dh_1 ... d/dh_m F(u + h_1 d_1 + ... + h_m d_m) at 0.
template <class Field>
typename Field::Element Evaluation<Field>::directional_derivative(const Node& node, Scope& scope) {
    const Direction& direction = shape(node.target).directions.front();
    const std::size_t order = node.groups.front();
    const std::vector<Geometric> arguments = map_arguments(node, order, scope);
    std::vector<Geometric> vectors;
    for (std::size_t i = 0; i < order; ++i) {
        vectors.push_back(geometric(node.children[i], scope));
        require_dimension(vectors.back(), direction.dimension, node.offset);
        if (!field_.is_zero(vectors.back().mass)) {
            fail(ErrorCode::wrong_kind, "a map on a simplex is differentiated along vectors", node.offset);
        }
    }
    if (!has_unit_mass(arguments.front())) {
        fail(ErrorCode::wrong_kind, "a derivative is taken at a point", node.offset);
    }
    const std::function<Element(const Geometric&, std::size_t)> along = [&](const Geometric& at,
                                                                            std::size_t place) -> Element {
        if (place == order) return contract(node.target, {value_weights(direction, at)});
        return field_.derivative(
            [&](const Element& step) {
                Geometric moved = at;
                for (std::size_t i = 0; i < moved.coordinates.size(); ++i) {
                    moved.coordinates[i] =
                        field_.sum(moved.coordinates[i], field_.product(step, vectors[place].coordinates[i]));
                }
                return along(moved, place + 1);
            },
            zero(), 1);
    };
    if (order > direction.degree) {
        contract(node.target, {value_weights(direction, arguments.front())});
        return zero();
    }
    return along({arguments.front().coordinates, one(), true}, 0);
}

template <class Field>
typename Field::Element Evaluation<Field>::derivative(const Node& node, Scope& scope) {
    const Node& variable = reading_.node(node.children[1]);
    if (variable.kind == Kind::geometric) {
        fail(ErrorCode::wrong_kind, "D differentiates with respect to a number", variable.offset);
    }
    std::size_t order = 1;
    if (node.children.size() > 2) {
        order = counting_.count(node.children[2], scope, reading_.limits().degree, "an order");
    }
    Key key = counting_.integers(variable.children, scope);
    key.push_back(static_cast<long long>(variable.text));
    std::optional<std::size_t> place;
    if (variable.meaning == Meaning::local) place = static_cast<std::size_t>(scope[variable.target].integer);
    if (variable.may_be_bound && bound_members_.contains(key)) place = bound_members_.at(key);
    if (place) {
        const Element kept = variables_[*place].coordinates.front();
        return field_.derivative(
            [&](const Element& value) {
                const AtEnd restore([&] { assign_variable(*place, kept); });
                assign_variable(*place, value);
                return number(node.children[0], scope);
            },
            kept, order);
    }
    if (variable.meaning == Meaning::abbreviation) {
        Scope inner;
        key.pop_back();
        if (counting_.fitting_clause(variable.target, key, inner) != nullptr) {
            fail(ErrorCode::wrong_kind, "D differentiates with respect to a number, not an abbreviation",
                 variable.offset);
        }
        key.push_back(static_cast<long long>(variable.text));
    }
    const Element kept = number(node.children[1], scope);
    // Known values of abbreviations and maps may contain the symbol with its old value.
    return field_.derivative(
        [&](const Element& value) {
            const AtEnd restore([&, layer = map_layer_] {
                symbols_.insert_or_assign(key, kept);
                known_.pop_back();
                map_layer_ = layer;
            });
            known_.emplace_back();
            map_layer_ = &known_.back();
            symbols_.insert_or_assign(key, value);
            return number(node.children[0], scope);
        },
        kept, order);
}

}  // namespace blossom::proofs::second
