#pragma once

#include "second_evaluation_class.hpp"

#include <blossom/rational/number_text.hpp>

namespace blossom::proofs::second {

template <class Field>
std::vector<typename Evaluation<Field>::Repeated> Evaluation<Field>::expand(const Node& node,
                                                                            std::size_t first,
                                                                            std::size_t last, Scope& scope) {
    std::vector<Repeated> found;
    for (std::size_t i = first; i < last; ++i) {
        const NodeId id = node.children[i];
        const Node& argument = reading_.node(id);
        if (argument.form == Form::copies) {
            const std::size_t count = counting_.count(argument.children[1], scope, reading_.limits().degree,
                                                      "the number of copies");
            if (count > 0) found.push_back({geometric(argument.children[0], scope), count});
        } else if (argument.form == Form::run) {
            expand_run(argument, found, scope);
        } else if (argument.form == Form::family) {
            for (const long long value : counting_.family_members(argument, scope)) {
                scope[argument.slot] = {value, nullptr, nullptr};
                found.push_back({geometric(argument.children.back(), scope), 1});
            }
        } else {
            found.push_back({geometric(id, scope), 1});
        }
    }
    return found;
}

template <class Field>
void Evaluation<Field>::expand_run(const Node& run, std::vector<Repeated>& found, Scope& scope) {
    const Node& from = reading_.node(run.children[0]);
    const Node& to = reading_.node(run.children[1]);
    Key indices = counting_.integers(from.children, scope);
    const Key last = counting_.integers(to.children, scope);
    if (!std::equal(indices.begin(), indices.end() - 1, last.begin())) {
        fail(ErrorCode::syntax, "only the last index of a run changes", run.offset);
    }
    for (; indices.back() <= last.back(); ++indices.back()) {
        counting_.work().step();
        Value value = member(from, indices);
        if (Geometric* point = std::get_if<Geometric>(&value)) {
            found.push_back({std::move(*point), 1});
        } else {
            found.push_back({point_of_number(std::get<Element>(std::move(value))), 1});
        }
    }
}

template <class Field>
typename Field::Element Evaluation<Field>::blossom(const Node& node, Scope& scope) {
    const MapShape& own = shape(node.target);
    if (node.groups.size() != own.directions.size()) {
        fail(ErrorCode::wrong_arity,
             quoted(reading_.name(node.text)) + " has " + std::to_string(own.directions.size()) +
                 " directions",
             node.offset);
    }
    std::vector<std::vector<Element>> weights;
    std::size_t first = 0;
    for (std::size_t i = 0; i < node.groups.size(); ++i) {
        const std::vector<Repeated> arguments = expand(node, first, node.groups[i], scope);
        weights.push_back(blossom_weights(own.directions[i], arguments, node.offset));
        first = node.groups[i];
    }
    return contract(node.target, weights);
}

// The polar form of x^e m^(n-|e|) is the mean over all ways to take coordinate 1 from e_1 of the arguments,
// and so on, and the mass from the others. The sums for all exponents are updated argument by argument.
template <class Field>
std::vector<typename Field::Element> Evaluation<Field>::blossom_weights(
    const Direction& direction, const std::vector<Repeated>& arguments, std::size_t offset) {
    std::size_t count = 0;
    std::map<std::vector<std::size_t>, Element> sums;
    sums.emplace(std::vector<std::size_t>(direction.dimension, 0), one());
    for (const Repeated& repeated : arguments) {
        const Geometric& argument = repeated.argument;
        require_dimension(argument, direction.dimension, offset);
        count += repeated.count;
        if (count > direction.degree) break;
        for (std::size_t copy = 0; copy < repeated.count; ++copy) {
            counting_.work().step(sums.size());
            std::map<std::vector<std::size_t>, Element> longer;
            const auto add = [&](const std::vector<std::size_t>& exponents, Element term) {
                const auto [place, is_new] = longer.try_emplace(exponents, term);
                if (!is_new) place->second = field_.sum(place->second, term);
            };
            for (const auto& [exponents, sum] : sums) {
                add(exponents, argument.unit_mass ? sum : field_.product(sum, argument.mass));
                std::vector<std::size_t> raised = exponents;
                for (std::size_t i = 0; i < raised.size(); ++i) {
                    ++raised[i];
                    add(raised, field_.product(sum, argument.coordinates[i]));
                    --raised[i];
                }
            }
            sums = std::move(longer);
        }
    }
    if (count != direction.degree) {
        fail(ErrorCode::wrong_arity,
             "a blossom of degree " + std::to_string(direction.degree) + " has " + std::to_string(count) +
                 " arguments",
             offset);
    }
    std::vector<Element> weights(direction.monomials.size(), zero());
    for (const auto& [exponents, sum] : sums) {
        const Rational ways = multinomial(direction.degree, exponents);
        weights[direction.place(exponents)] = field_.product(sum, field_.number(Rational(1) / ways));
    }
    return weights;
}

// Column k of the matrix has the coordinates and the mass of the k-th point; the forms are the rows of its
// inverse.
template <class Field>
std::vector<std::vector<typename Field::Element>> Evaluation<Field>::net_forms(const MapDeclaration& map,
                                                                               std::size_t dimension) {
    Scope scope;
    const Node& list = reading_.node(map.body);
    scope.resize(map.slots);
    const std::vector<Repeated> repeated = expand(list, 0, list.children.size(), scope);
    std::vector<std::vector<Element>> matrix;
    for (const Repeated& point : repeated) {
        require_dimension(point.argument, dimension, map.offset);
        if (!has_unit_mass(point.argument)) {
            fail(ErrorCode::wrong_kind, "a net has control points over points, of mass 1", map.offset);
        }
        matrix.insert(matrix.end(), point.count, point.argument.coordinates);
        for (std::size_t i = 0; i < point.count; ++i) matrix[matrix.size() - 1 - i].push_back(one());
    }
    if (matrix.size() != dimension + 1) {
        fail(ErrorCode::wrong_arity,
             "a net over a simplex of dimension " + std::to_string(dimension) + " has " +
                 std::to_string(dimension + 1) + " points",
             map.offset);
    }
    require_within(matrix.size(), 12, "variables", "the points of a net");
    const Element determinant = determinant_of(matrix);
    std::vector<std::vector<Element>> forms(matrix.size());
    for (std::size_t point = 0; point < matrix.size(); ++point) {
        for (std::size_t coordinate = 0; coordinate < matrix.size(); ++coordinate) {
            std::vector<std::vector<Element>> minor;
            for (std::size_t row = 0; row < matrix.size(); ++row) {
                if (row == point) continue;
                minor.push_back(matrix[row]);
                minor.back().erase(minor.back().begin() + static_cast<long>(coordinate));
            }
            Element cofactor = determinant_of(minor);
            if ((point + coordinate) % 2 == 1) cofactor = field_.negative(cofactor);
            forms[point].push_back(field_.quotient(cofactor, determinant));
        }
    }
    return forms;
}

// F is the sum of multinomial * c_i * l_0^i_0 ... l_s^i_s in the barycentric forms l. Each product of powers
// of l_1, ..., l_s is computed from its predecessor, as a list of coefficients of monomials in x_1, ..., x_s.
template <class Field>
std::vector<typename Field::Element> Evaluation<Field>::net_coefficients(const MapDeclaration& map,
                                                                         const MapShape& shape) {
    const Direction& direction = shape.directions.front();
    const std::size_t dimension = direction.dimension;
    const std::vector<std::vector<Element>> forms = net_forms(map, dimension);
    using Polynomial = std::map<std::vector<std::size_t>, Element>;
    const auto times_form = [&](const Polynomial& polynomial, const std::vector<Element>& form) {
        Polynomial result;
        for (const auto& [exponents, coefficient] : polynomial) {
            counting_.work().step();
            for (std::size_t i = 0; i <= dimension; ++i) {
                std::vector<std::size_t> raised = exponents;
                if (i < dimension) ++raised[i];
                const Element term = field_.product(coefficient, form[i]);
                const auto [place, is_new] = result.try_emplace(std::move(raised), term);
                if (!is_new) place->second = field_.sum(place->second, term);
            }
        }
        return result;
    };
    std::vector<Element> found(shape.size(), zero());
    for (const std::vector<std::size_t>& exponents : direction.monomials) {
        std::size_t left = direction.degree;
        Polynomial product{{std::vector<std::size_t>(dimension, 0), one()}};
        for (std::size_t i = 0; i < dimension; ++i) {
            left -= exponents[i];
            for (std::size_t k = 0; k < exponents[i]; ++k) product = times_form(product, forms[i + 1]);
        }
        for (std::size_t k = 0; k < left; ++k) product = times_form(product, forms.front());
        Key indices;
        if (dimension > 1) indices.push_back(static_cast<long long>(left));
        for (const std::size_t exponent : exponents) indices.push_back(static_cast<long long>(exponent));
        const Element scale =
            field_.product(net_value(map, indices), field_.number(multinomial(direction.degree, exponents)));
        for (const auto& [monomial, coefficient] : product) {
            Element& total = found[direction.place(monomial)];
            total = field_.sum(total, field_.product(scale, coefficient));
        }
    }
    return found;
}

template <class Field>
typename Field::Element Evaluation<Field>::net_value(const MapDeclaration& map, const Key& indices) {
    const Node& family = reading_.node(map.control_points);
    const Value value = member(family, indices);
    if (const Element* found = std::get_if<Element>(&value)) return *found;
    fail(ErrorCode::wrong_kind, "the values of a net are numbers", map.offset);
}

}  // namespace blossom::proofs::second
