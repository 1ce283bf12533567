#pragma once

#include "second_evaluation_class.hpp"

#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <bit>

namespace blossom::proofs::second {

template <class Field>
typename Field::Element Evaluation<Field>::number(NodeId id, Scope& scope) {
    const Node& node = reading_.node(id);
    if (node.kind == Kind::integer) return field_.number(counting_.value(id, scope));
    const WorkLimit::Level level(counting_.work());
    return number_of_form(node, scope);
}

template <class Field>
typename Field::Element Evaluation<Field>::number_of_form(const Node& node, Scope& scope) {
    switch (node.form) {
        case Form::number:
            return field_.number(node.value);
        case Form::name:
        case Form::member:
            return name_value(node, scope);
        case Form::terms:
            return terms(node, scope);
        case Form::factors:
            return factors(node, scope);
        case Form::negation:
            return field_.negative(number(node.children[0], scope));
        case Form::power:
            return power(node, scope);
        case Form::sum:
        case Form::product:
        case Form::mean:
            return iteration(node, scope);
        case Form::determinant:
            return determinant(node, scope);
        case Form::bernstein:
            return bernstein(node, scope);
        case Form::basis:
            return basis(node, scope);
        case Form::choice:
            return number(node.children[counting_.holds(node.children[0], scope) ? 1 : 2], scope);
        case Form::map_value:
            return map_value(node, scope);
        case Form::map_derivative:
            return map_derivative(node, scope);
        case Form::blossom:
            return blossom(node, scope);
        case Form::derivative:
            return derivative(node, scope);
        default:
            fail(ErrorCode::wrong_kind, "a number is expected here", node.offset);
    }
}

template <class Field>
typename Field::Element Evaluation<Field>::name_value(const Node& node, Scope& scope) {
    if (node.form == Form::name && node.meaning == Meaning::free_number) return symbol(node.text, {});
    if (node.meaning == Meaning::local) {
        return variables_[static_cast<std::size_t>(scope[node.target].integer)].coordinates.front();
    }
    const Value value = member(node, counting_.integers(node.children, scope));
    if (const Element* found = std::get_if<Element>(&value)) return *found;
    fail(ErrorCode::wrong_kind, quoted(reading_.name(node.text)) + " is no number here", node.offset);
}

template <class Field>
typename Field::Element Evaluation<Field>::terms(const Node& node, Scope& scope) {
    Element total = number(node.children[0], scope);
    for (std::size_t i = 1; i < node.children.size(); ++i) {
        const Element term = number(node.children[i], scope);
        total = field_.sum(total, node.flags[i] ? field_.negative(term) : term);
    }
    return total;
}

template <class Field>
typename Field::Element Evaluation<Field>::factors(const Node& node, Scope& scope) {
    Element total = number(node.children[0], scope);
    for (std::size_t i = 1; i < node.children.size(); ++i) {
        const Element factor = number(node.children[i], scope);
        total = node.flags[i] ? field_.quotient(total, factor) : field_.product(total, factor);
    }
    return total;
}

template <class Field>
typename Field::Element Evaluation<Field>::power(const Node& node, Scope& scope) {
    const Element base = number(node.children[0], scope);
    const long long exponent = counting_.integer(node.children[1], scope);
    const auto size = static_cast<std::size_t>(exponent < 0 ? -exponent : exponent);
    require_within(size, reading_.limits().degree, "degree", "the exponent");
    const Element result = field_.power(base, size);
    return exponent < 0 ? field_.quotient(one(), result) : result;
}

template <class Field>
typename Field::Element Evaluation<Field>::iteration(const Node& node, Scope& scope) {
    std::optional<Element> total;
    long long members = 0;
    counting_.each(node.children[0], node.slot, scope, [&] {
        Element member = number(node.children[1], scope);
        if (!total) {
            total = std::move(member);
        } else {
            total = node.form == Form::product ? field_.product(*total, member) : field_.sum(*total, member);
        }
        ++members;
    });
    if (node.form == Form::mean) {
        if (members == 0) fail(ErrorCode::division_by_zero, "a mean of nothing", node.offset);
        return field_.product(*total, field_.number(Rational(1) / Rational(members)));
    }
    if (total) return *total;
    return node.form == Form::product ? one() : zero();
}

template <class Field>
typename Field::Element Evaluation<Field>::bernstein(const Node& node, Scope& scope) {
    const long long i = counting_.integer(node.children[0], scope);
    const std::size_t n = counting_.count(node.children[1], scope, reading_.limits().degree, "a degree");
    const Element at = number(node.children[2], scope);
    if (i < 0 || i > static_cast<long long>(n)) return zero();
    const auto power = static_cast<std::size_t>(i);
    const Element rest = field_.power(difference(one(), at), n - power);
    return field_.product(field_.number(Rational(blossom::binomial(n, power))),
                          field_.product(field_.power(at, power), rest));
}

template <class Field>
typename Field::Element Evaluation<Field>::determinant(const Node& node, Scope& scope) {
    const std::size_t size =
        counting_.count(node.children[2], scope, reading_.limits().degree, "the size of a determinant");
    if (size > 16) fail(ErrorCode::limit_exceeded, "a determinant has at most 16 rows", node.offset);
    std::vector<std::vector<Element>> matrix(size);
    for (std::size_t row = 0; row < size; ++row) {
        for (std::size_t column = 0; column < size; ++column) {
            scope[node.slot] = {static_cast<long long>(row + 1), nullptr, nullptr};
            scope[node.slot + 1] = {static_cast<long long>(column + 1), nullptr, nullptr};
            matrix[row].push_back(number(node.children[3], scope));
        }
    }
    return determinant_of(matrix);
}

// Row by row for every set of columns, without division: minors[set] is the determinant of the first rows and
// these columns.
template <class Field>
typename Field::Element Evaluation<Field>::determinant_of(const std::vector<std::vector<Element>>& matrix) {
    const std::size_t size = matrix.size();
    std::vector<std::optional<Element>> minors(std::size_t{1} << size);
    minors[0] = one();
    for (std::size_t set = 1; set < minors.size(); ++set) {
        counting_.work().step(size);
        const std::vector<Element>& row = matrix[static_cast<std::size_t>(std::popcount(set)) - 1];
        Element total = zero();
        bool subtract = false;
        for (std::size_t column = size; column-- > 0;) {
            if ((set >> column & 1) == 0) continue;
            const Element term = field_.product(row[column], *minors[set & ~(std::size_t{1} << column)]);
            total = field_.sum(total, subtract ? field_.negative(term) : term);
            subtract = !subtract;
        }
        minors[set] = std::move(total);
    }
    return *minors.back();
}

template <class Field>
typename Field::Element Evaluation<Field>::basis(const Node& node, Scope& scope) {
    const long long j = counting_.integer(node.children[0], scope);
    const std::size_t degree =
        counting_.count(node.children[1], scope, reading_.limits().degree, "the degree of a B-spline");
    const long long span = counting_.integer(node.children[2], scope);
    const Element at = number(node.children[3], scope);
    return basis_function(node, j, static_cast<long long>(degree), span, at).value_or(zero());
}

// Does nothing if the function vanishes on the span for all knots: then its denominators are not formed.
template <class Field>
std::optional<typename Field::Element> Evaluation<Field>::basis_function(const Node& node, long long j,
                                                                         long long degree, long long span,
                                                                         const Element& at) {
    const WorkLimit::Level level(counting_.work());
    if (span < j || span > j + degree) return std::nullopt;
    if (degree == 0) return one();
    const auto knot = [&](long long index) {
        const Value value = member(node, {index});
        if (const Element* found = std::get_if<Element>(&value)) return *found;
        fail(ErrorCode::wrong_kind, "the knots of bspline are numbers", node.offset);
    };
    Element total = zero();
    if (const auto first = basis_function(node, j, degree - 1, span, at)) {
        const Element weight =
            field_.quotient(difference(at, knot(j)), difference(knot(j + degree), knot(j)));
        total = field_.product(weight, *first);
    }
    if (const auto second = basis_function(node, j + 1, degree - 1, span, at)) {
        const Element weight = field_.quotient(difference(knot(j + degree + 1), at),
                                               difference(knot(j + degree + 1), knot(j + 1)));
        total = field_.sum(total, field_.product(weight, *second));
    }
    return total;
}

}  // namespace blossom::proofs::second
