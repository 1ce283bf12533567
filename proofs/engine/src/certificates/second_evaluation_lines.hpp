#pragma once

#include "second_evaluation.hpp"

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
        Outside outside = begin_variables();
        const AtEnd forget([&] {
            bound_members_.clear();
            forget_variables(outside);
        });
        bind_all(statement, scope);
        known_.emplace_back();
        Element left = number(statement.left, scope);
        found.emplace_back(std::move(left), number(statement.right, scope));
    });
}

template <class Field>
typename Evaluation<Field>::Outside Evaluation<Field>::begin_variables() {
    Outside outside{variables_.size(), {}, {}};
    if (!lets_see_variables()) return outside;
    outside.symbols = symbols_;
    outside.points = points_;
    known_.emplace_back();
    return outside;
}

template <class Field>
std::size_t Evaluation<Field>::add_variable(Key key, Geometric value) {
    if (lets_see_variables()) {
        if (value.coordinates.size() == 1) symbols_.insert_or_assign(key, value.coordinates.front());
        points_.insert_or_assign(key, value);
    }
    variables_.push_back(std::move(value));
    variable_keys_.push_back(std::move(key));
    return variables_.size() - 1;
}

template <class Field>
void Evaluation<Field>::assign_variable(std::size_t place, const Element& value) {
    variables_[place].coordinates.front() = value;
    if (!lets_see_variables()) return;
    symbols_.insert_or_assign(variable_keys_[place], value);
    known_.back() = Known();
}

// Symbols that were met inside for the first time are kept: the field is asked once for each.
template <class Field>
void Evaluation<Field>::forget_variables(Outside& outside) {
    if (lets_see_variables()) {
        for (std::size_t i = outside.first; i < variable_keys_.size(); ++i) {
            symbols_.erase(variable_keys_[i]);
            points_.erase(variable_keys_[i]);
        }
        for (auto& [key, value] : outside.symbols) symbols_.insert_or_assign(key, std::move(value));
        for (auto& [key, value] : outside.points) points_.insert_or_assign(key, std::move(value));
        known_.pop_back();
    }
    const auto first = static_cast<long>(outside.first);
    variables_.erase(variables_.begin() + first, variables_.end());
    variable_keys_.erase(variable_keys_.begin() + first, variable_keys_.end());
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
const typename Evaluation<Field>::Geometric* Evaluation<Field>::taken(const Key& key, Kind kind) const {
    for (std::size_t i = taken_.size(); i-- > 0;) {
        if (taken_[i].key == key && taken_[i].kind == kind) return &taken_[i].value;
    }
    return nullptr;
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
