#pragma once

#include "second_evaluation_class.hpp"

namespace blossom::proofs::second {

template <class Field>
Evaluation<Field>::Evaluation(const Reading& reading, const Case& which, Field& field)
    : reading_(reading), case_(which), field_(field), counting_(reading, {}), known_(1) {
    const std::size_t count = reading.parameters().size();
    if (which.line >= reading.claims().size() ||
        which.parameters.size() != count + reading.claims()[which.line].ranges.size()) {
        fail(ErrorCode::wrong_arity, "this is no case of the block", 0);
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (which.parameters[i].first != reading.name(reading.parameters()[i].name)) {
            fail(ErrorCode::unknown_field, "this is no case of the block", 0);
        }
        counting_.push_parameter(which.parameters[i].second);
    }
}

template <class Field>
Scope Evaluation<Field>::claim_scope() const {
    Scope scope(claim().slots);
    const std::size_t first = reading_.parameters().size();
    for (std::size_t i = 0; i < claim().ranges.size(); ++i) {
        scope[i].integer = case_.parameters[first + i].second;
    }
    return scope;
}

template <class Field>
typename Field::Element Evaluation<Field>::left() {
    Scope scope = claim_scope();
    return number(claim().left, scope);
}

template <class Field>
typename Field::Element Evaluation<Field>::right() {
    Scope scope = claim_scope();
    return number(claim().right, scope);
}

template <class Field>
std::vector<std::pair<typename Field::Element, typename Field::Element>> Evaluation<Field>::hypotheses() {
    std::vector<std::pair<Element, Element>> found;
    for (const Statement& statement : reading_.hypotheses()) each_case(statement, found);
    return found;
}

template <class Field>
std::vector<std::pair<typename Field::Element, typename Field::Element>> Evaluation<Field>::hypotheses(
    std::size_t line) {
    std::vector<std::pair<Element, Element>> found;
    each_case(reading_.hypotheses()[line], found);
    return found;
}

template <class Field>
std::vector<std::pair<typename Field::Element, typename Field::Element>> Evaluation<Field>::assumptions() {
    std::vector<std::pair<Element, Element>> found;
    for (const Statement& statement : reading_.assumptions()) each_case(statement, found);
    return found;
}

template <class Field>
void Evaluation<Field>::each_case(const Statement& statement,
                                  std::vector<std::pair<Element, Element>>& found) {
    Scope scope(statement.slots);
    counting_.each_range(statement.ranges, scope, [&] {
        const std::size_t first = begin_variables();
        const AtEnd forget([&] {
            bound_members_.clear();
            forget_variables(first);
        });
        bind_all(statement, scope);
        Element left = number(statement.left, scope);
        found.emplace_back(std::move(left), number(statement.right, scope));
    });
}

template <class Field>
std::size_t Evaluation<Field>::begin_variables() {
    known_.emplace_back();
    return variables_.size();
}

template <class Field>
std::size_t Evaluation<Field>::add_variable(Key key, Geometric value) {
    variables_.push_back(std::move(value));
    variable_keys_.push_back(std::move(key));
    return variables_.size() - 1;
}

// Known values of abbreviations may contain the variable with its old value.
template <class Field>
void Evaluation<Field>::assign_variable(std::size_t place, const Element& value) {
    variables_[place].coordinates.front() = value;
    known_.back() = Known();
}

template <class Field>
void Evaluation<Field>::forget_variables(std::size_t first) {
    variables_.erase(variables_.begin() + static_cast<long>(first), variables_.end());
    variable_keys_.erase(variable_keys_.begin() + static_cast<long>(first), variable_keys_.end());
    known_.pop_back();
}

template <class Field>
const typename Evaluation<Field>::Geometric* Evaluation<Field>::variable(const Key& key) const {
    for (std::size_t i = variables_.size(); i-- > first_visible_;) {
        if (variable_keys_[i] == key) return &variables_[i];
    }
    return nullptr;
}

template <class Field>
void Evaluation<Field>::bind_all(const Statement& statement, Scope& scope) {
    for (const Quantified& quantified : statement.for_all) {
        const std::string& name = reading_.name(quantified.name);
        if (quantified.bare) {
            scope[quantified.slot].integer = static_cast<long long>(
                add_variable({static_cast<long long>(quantified.name)}, bound_value(quantified, name)));
            continue;
        }
        Key first = counting_.integers(quantified.first, scope);
        const Key last = counting_.integers(quantified.last, scope);
        for (; first.back() <= last.back(); ++first.back()) {
            counting_.work().step();
            for (std::size_t i = 0; i < reading_.abbreviations().size(); ++i) {
                const Abbreviation& let = reading_.abbreviations()[i];
                Scope inner;
                if (let.bare || let.name != quantified.name) continue;
                if (counting_.fitting_clause(static_cast<std::uint32_t>(i), first, inner) == nullptr)
                    continue;
                fail(ErrorCode::syntax, "\"for all\" binds an abbreviation, " + name_of_member(name, first),
                     statement.offset);
            }
            Key key = first;
            key.push_back(static_cast<long long>(quantified.name));
            bound_members_[key] = add_variable(key, bound_value(quantified, name_of_member(name, first)));
        }
    }
}

template <class Field>
typename Evaluation<Field>::Geometric Evaluation<Field>::bound_value(const Quantified& quantified,
                                                                     const std::string& name) {
    if (!quantified.declaration) return point_of_number(field_.bound(name));
    const Declaration& declaration = reading_.declarations()[*quantified.declaration];
    const bool is_point = declaration.kind == Declaration::Kind::point;
    Geometric value{{}, is_point ? one() : zero(), is_point};
    const std::size_t dimension = counting_.dimension(declaration);
    for (std::size_t i = 1; i <= dimension; ++i) {
        value.coordinates.push_back(field_.bound(name + "." + std::to_string(i)));
    }
    return value;
}

}  // namespace blossom::proofs::second
