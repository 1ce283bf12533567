#pragma once

#include "second_evaluation_class.hpp"

#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

namespace blossom::proofs::second {

template <class Field>
const MapShape& Evaluation<Field>::shape(std::uint32_t map) {
    const auto known = shapes_.find(map);
    if (known != shapes_.end()) return known->second;
    return shapes_.emplace(map, shape_of_map(reading_, map, counting_)).first->second;
}

template <class Field>
const std::vector<typename Field::Element>& Evaluation<Field>::coefficients(std::uint32_t map) {
    const bool is_free = reading_.maps()[map].kind == MapDeclaration::Kind::free;
    const auto all = [&]() -> std::map<std::uint32_t, std::vector<Element>>& {
        return is_free ? free_maps_ : (map_layer_ ? *map_layer_ : known_.front()).coefficients;
    };
    const auto known = all().find(map);
    if (known != all().end()) return known->second;
    if (std::ranges::find(maps_in_work_, map) != maps_in_work_.end()) {
        fail(ErrorCode::syntax, quoted(reading_.name(reading_.maps()[map].name)) + " is defined by itself",
             reading_.maps()[map].offset);
    }
    maps_in_work_.push_back(map);
    const AtEnd forget([&] { maps_in_work_.pop_back(); });
    const AtEnd restore([&, visible = first_visible_] { first_visible_ = visible; });
    first_visible_ = variables_.size();
    known_.emplace_back();
    std::vector<Element> found = find_coefficients(map);
    known_.pop_back();
    return all().emplace(map, std::move(found)).first->second;
}

template <class Field>
std::vector<typename Field::Element> Evaluation<Field>::find_coefficients(std::uint32_t map) {
    const WorkLimit::Level level(counting_.work());
    const MapDeclaration& declaration = reading_.maps()[map];
    const MapShape& own = shape(map);
    switch (declaration.kind) {
        case MapDeclaration::Kind::free:
            return free_coefficients(declaration, own);
        case MapDeclaration::Kind::raised:
            return raised_coefficients(declaration, own);
        case MapDeclaration::Kind::net:
            return net_coefficients(declaration, own);
        case MapDeclaration::Kind::polynomial:
            return polynomial_coefficients(declaration, own);
    }
    return {};
}

template <class Field>
std::vector<typename Field::Element> Evaluation<Field>::free_coefficients(const MapDeclaration& map,
                                                                          const MapShape& shape) {
    std::vector<Element> found;
    const std::string& name = reading_.name(map.name);
    for (std::size_t place = 0; place < shape.size(); ++place) {
        const std::string text = name + shape.suffix(place);
        found.push_back(field_.symbol(text));
    }
    return found;
}

// The same polynomial: the coefficients of additional monomials are 0.
template <class Field>
std::vector<typename Field::Element> Evaluation<Field>::raised_coefficients(const MapDeclaration& map,
                                                                            const MapShape& shape) {
    const std::vector<Element>& source = coefficients(map.source);
    const MapShape& source_shape = this->shape(map.source);
    std::map<std::vector<std::size_t>, std::size_t> places;
    for (std::size_t place = 0; place < source.size(); ++place)
        places.emplace(source_shape.exponents(place), place);
    std::vector<Element> found;
    for (std::size_t place = 0; place < shape.size(); ++place) {
        const auto known = places.find(shape.exponents(place));
        found.push_back(known == places.end() ? zero() : source[known->second]);
    }
    return found;
}

template <class Field>
std::vector<typename Field::Element> Evaluation<Field>::polynomial_coefficients(const MapDeclaration& map,
                                                                                const MapShape& shape) {
    Scope scope(map.slots);
    const std::size_t first = begin_variables();
    const AtEnd forget([&] { forget_variables(first); });
    for (std::size_t i = 0; i < map.variables.size(); ++i) {
        const Key key{static_cast<long long>(map.variables[i])};
        scope[i].integer = static_cast<long long>(add_variable(key, point_of_number(zero())));
    }
    try {
        return coefficients_from(map, shape, 0, shape.directions.front().degree, scope);
    } catch (const Error& error) {
        if (error.offset()) throw;
        throw error.at(reading_.node(map.body).offset);
    }
}

// On a simplex, `degree` is what remains of the degree after the previous variables. A coefficient of the
// later variables is a polynomial in this one.
template <class Field>
std::vector<typename Field::Element> Evaluation<Field>::coefficients_from(const MapDeclaration& map,
                                                                          const MapShape& shape,
                                                                          std::size_t variable,
                                                                          std::size_t degree, Scope& scope) {
    if (variable == map.variables.size()) return {number(map.body, scope)};
    const auto place = static_cast<std::size_t>(scope[variable].integer);
    const bool is_tensor = shape.directions.size() > 1;
    const std::size_t later = map.variables.size() - variable - 1;
    const std::size_t own = is_tensor ? shape.directions[variable].degree : degree;
    MapShape rest;
    if (is_tensor) {
        rest.directions.assign(shape.directions.begin() + static_cast<long>(variable) + 1,
                               shape.directions.end());
    } else if (later > 0) {
        rest.directions.push_back(direction_of(later, degree, reading_.limits()));
    }
    std::map<std::vector<std::size_t>, Element> by_exponents;
    for (std::size_t i = 0; i < rest.size(); ++i) {
        std::vector<std::size_t> exponents = rest.exponents(i);
        std::size_t left = own;
        if (!is_tensor) {
            for (const std::size_t exponent : exponents) left -= exponent;
        }
        const std::vector<Element> powers = field_.coefficients(
            [&](const Element& value) {
                assign_variable(place, value);
                return coefficients_from(map, shape, variable + 1, degree, scope)[i];
            },
            left);
        exponents.insert(exponents.begin(), 0);
        for (std::size_t power = 0; power <= left; ++power) {
            exponents.front() = power;
            by_exponents.emplace(exponents, powers[power]);
        }
    }
    // Monomials are numbered in the lexicographic order of their exponents.
    std::vector<Element> found;
    found.reserve(by_exponents.size());
    for (auto& [exponents, coefficient] : by_exponents) found.push_back(std::move(coefficient));
    return found;
}

template <class Field>
void Evaluation<Field>::require_dimension(const Geometric& value, std::size_t dimension,
                                          std::size_t offset) const {
    if (value.coordinates.size() == dimension) return;
    fail(ErrorCode::mismatched_dimensions,
         "an argument of dimension " + std::to_string(value.coordinates.size()) + " for a map of dimension " +
             std::to_string(dimension),
         offset);
}

template <class Field>
bool Evaluation<Field>::has_unit_mass(const Geometric& value) {
    return value.unit_mass || field_.is_zero(difference(value.mass, one()));
}

template <class Field>
std::vector<typename Evaluation<Field>::Geometric> Evaluation<Field>::map_arguments(const Node& node,
                                                                                    std::size_t first,
                                                                                    Scope& scope) {
    const MapShape& own = shape(node.target);
    const std::size_t count = node.children.size() - first;
    const std::size_t dimension = own.directions.front().dimension;
    std::vector<Geometric> found;
    if (own.directions.size() == 1 && dimension > 1 && count == dimension) {
        Geometric point{{}, one(), true};
        for (std::size_t i = first; i < node.children.size(); ++i) {
            point.coordinates.push_back(number(node.children[i], scope));
        }
        found.push_back(std::move(point));
        return found;
    }
    if (count != own.directions.size()) {
        fail(ErrorCode::wrong_arity,
             quoted(reading_.name(node.text)) + " has " + std::to_string(own.directions.size()) +
                 " arguments, not " + std::to_string(count),
             node.offset);
    }
    for (std::size_t i = 0; i < count; ++i) {
        found.push_back(geometric(node.children[first + i], scope));
        require_dimension(found.back(), own.directions[i].dimension, node.offset);
    }
    return found;
}

template <class Field>
typename Field::Element Evaluation<Field>::map_value(const Node& node, Scope& scope) {
    const std::vector<Geometric> arguments = map_arguments(node, 0, scope);
    std::vector<std::vector<Element>> weights;
    weights.reserve(arguments.size());
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        weights.push_back(value_weights(shape(node.target).directions[i], arguments[i]));
    }
    return contract(node.target, weights);
}

template <class Field>
std::vector<typename Field::Element> Evaluation<Field>::value_weights(const Direction& direction,
                                                                      const Geometric& at) {
    counting_.work().step(direction.monomials.size());
    const auto powers_of = [&](const Element& base) {
        std::vector<Element> powers{one()};
        for (std::size_t i = 1; i <= direction.degree; ++i)
            powers.push_back(field_.product(powers.back(), base));
        return powers;
    };
    std::vector<std::vector<Element>> powers;
    powers.reserve(at.coordinates.size());
    for (const Element& coordinate : at.coordinates) powers.push_back(powers_of(coordinate));
    std::vector<Element> masses;
    if (!at.unit_mass) masses = powers_of(at.mass);
    std::vector<Element> weights;
    weights.reserve(direction.monomials.size());
    for (const std::vector<std::size_t>& exponents : direction.monomials) {
        std::size_t left = direction.degree;
        std::optional<Element> weight;
        for (std::size_t i = 0; i < exponents.size(); ++i) {
            left -= exponents[i];
            const Element& power = powers[i][exponents[i]];
            weight = weight ? field_.product(*weight, power) : power;
        }
        if (!weight) weight = one();
        weights.push_back(at.unit_mass ? std::move(*weight) : field_.product(*weight, masses[left]));
    }
    return weights;
}

template <class Field>
typename Field::Element Evaluation<Field>::contract(std::uint32_t map,
                                                    const std::vector<std::vector<Element>>& weights) {
    const std::vector<Element>& all = coefficients(map);
    counting_.work().step(all.size());
    const std::vector<Element>* row = &all;
    std::vector<Element> kept;
    for (std::size_t direction = weights.size(); direction-- > 0;) {
        const std::vector<Element>& own = weights[direction];
        std::vector<Element> shorter;
        for (std::size_t begin = 0; begin < row->size(); begin += own.size()) {
            Element total = field_.product((*row)[begin], own.front());
            for (std::size_t i = 1; i < own.size(); ++i) {
                total = field_.sum(total, field_.product((*row)[begin + i], own[i]));
            }
            shorter.push_back(std::move(total));
        }
        kept = std::move(shorter);
        row = &kept;
    }
    return kept.front();
}

}  // namespace blossom::proofs::second
