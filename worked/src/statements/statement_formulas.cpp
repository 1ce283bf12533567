#include "statement_formulas.hpp"

#include <blossom/rational/lists.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace blossom::worked {

using proofs::Expression;
using proofs::ExpressionKind;

namespace {

/// The relations of the language in the signs of mathematics.
std::string sign_of(const std::string& comparison) {
    if (comparison == "==") return "=";
    if (comparison == "!=") return "≠";
    if (comparison == "<=") return "≤";
    if (comparison == ">=") return "≥";
    if (comparison == "in") return "∈";
    return comparison == "not in" ? "∉" : comparison;
}

/// Up to so many equal arguments, or members of a run, are written out.
constexpr std::size_t most_written = 3;

bool is_number(const Expression& expression) { return expression.kind == ExpressionKind::number; }

/// A small integer that is written as such.
std::optional<std::size_t> small_integer(const Expression& expression) {
    const bool small = is_number(expression) && expression.name.size() < 4 &&
                       expression.name.find_first_not_of("0123456789") == std::string::npos;
    return small ? std::optional(std::stoul(expression.name)) : std::nullopt;
}

std::optional<std::size_t> last_index(const Expression& name) {
    return name.children.empty() ? std::nullopt : small_integer(name.children.back());
}

}  // namespace

Formula StatementFormulas::operator()(const Expression& e) {
    switch (e.kind) {
        case ExpressionKind::number:
            return number(parse_rational(e.name));
        case ExpressionKind::name:
            return name(e);
        case ExpressionKind::negative:
            return negative(e.children[0]);
        case ExpressionKind::sum:
            return sum(terms(e));
        case ExpressionKind::product:
            return product(factors(e));
        case ExpressionKind::power:
            return power((*this)(e.children[0]), (*this)(e.children[1]));
        case ExpressionKind::pair:
            return pair_of((*this)(e.children[0]), (*this)(e.children[1]));
        case ExpressionKind::point:
            return tuple(list(e.children));
        case ExpressionKind::call:
            return call(e);
        case ExpressionKind::comparison:
            return relation(sign_of(e.name), list(e.children));
        case ExpressionKind::value:
            return value(e);
        case ExpressionKind::derivative:
            return derivative(e);
        case ExpressionKind::blossom:
            return blossom(e);
        case ExpressionKind::copies:
        case ExpressionKind::run:
        case ExpressionKind::family:
            return list_of(entries(e));
    }
    return {};
}

std::vector<Formula> StatementFormulas::list(const std::vector<Expression>& expressions) {
    std::vector<Formula> formulas;
    for (const Expression& one : expressions) std::ranges::move(entries(one), std::back_inserter(formulas));
    return formulas;
}

Formula StatementFormulas::negative(const Expression& expression) {
    if (is_number(expression)) return number(-parse_rational(expression.name));
    std::vector<Formula> parts = factors(expression);
    parts.insert(parts.begin(), number(-1));
    return product(std::move(parts));
}

std::vector<Formula> StatementFormulas::terms(const Expression& e) {
    if (e.kind != ExpressionKind::sum) return {(*this)(e)};
    std::vector<Formula> all{(*this)(e.children[0])};
    for (std::size_t i = 1; i < e.children.size(); ++i)
        all.push_back(e.name[i - 1] == '+' ? (*this)(e.children[i]) : negative(e.children[i]));
    return all;
}

/// The factors of a product, a quotient being one of them. A sign in front is a factor -1.
std::vector<Formula> StatementFormulas::factors(const Expression& e) {
    if (e.kind != ExpressionKind::product) {
        Formula only = (*this)(e);
        if (only.kind == FormulaKind::product && e.kind == ExpressionKind::negative)
            return std::move(only.parts);
        return {std::move(only)};
    }
    std::vector<Formula> all = factors(e.children[0]);
    for (std::size_t i = 1; i < e.children.size(); ++i) {
        Formula next = (*this)(e.children[i]);
        if (e.name[i - 1] == '/') next = fraction(product(std::exchange(all, {})), std::move(next));
        all.push_back(std::move(next));
    }
    return all;
}

Formula StatementFormulas::name(const Expression& e) {
    return e.children.empty() ? symbol(e.name) : index(symbol(e.name), list_of(list(e.children)));
}

Formula StatementFormulas::at_variables(const std::vector<std::string>& names) {
    std::vector<Formula> variables;
    for (std::size_t i = 1; i < names.size(); ++i) variables.push_back(symbol(names[i]));
    return worked::call(names.front(), std::move(variables));
}

Formula StatementFormulas::value(const Expression& e) {
    std::vector<Formula> arguments = list(e.groups[0]);
    if (e.children.empty()) return worked::call(e.name, std::move(arguments));
    std::vector<Formula> head;
    if (takes_directions(e.name)) {
        for (const Expression& along : e.children) head.push_back(index(symbol("D"), (*this)(along)));
    } else if (e.children.size() == 1) {
        const std::optional<std::size_t> order = small_integer(e.children[0]);
        if (order && arguments.size() == 1)
            return derivative_of(e.name, *order, std::move(arguments.front()));
        return application(power(symbol(e.name), tuple({(*this)(e.children[0])})), std::move(arguments));
    } else {
        for (std::size_t i = 0; i < e.children.size(); ++i) {
            if (small_integer(e.children[i]) == 0U) continue;
            head.push_back(power(index(symbol("∂"), number(i + 1)), (*this)(e.children[i])));
        }
    }
    head.push_back(symbol(e.name));
    return application(product(std::move(head)), std::move(arguments));
}

Formula StatementFormulas::derivative(const Expression& e) {
    const Formula order = e.children.size() == 3 ? (*this)(e.children[2]) : number(1);
    const Formula below = product({symbol("∂"), power((*this)(e.children[1]), order)});
    std::vector<Formula> parts = factors(e.children[0]);
    parts.insert(parts.begin(), fraction(power(symbol("∂"), order), below));
    return product(std::move(parts));
}

Formula StatementFormulas::blossom(const Expression& e) {
    if (e.groups.size() == 1) return blossom_of(e.name, list(e.groups[0]));
    return blossom_of(
        e.name, {list_of(mapped(e.groups, [&](const auto& group) { return list_of(list(group)); }), ";")});
}

std::vector<Formula> StatementFormulas::entries(const Expression& e) {
    if (e.kind == ExpressionKind::family) return {family(e)};
    if (e.kind == ExpressionKind::copies) {
        const std::optional<std::size_t> times = small_integer(e.children[1]);
        if (times && *times <= most_written) return std::vector<Formula>(*times, (*this)(e.children[0]));
        return {repeated((*this)(e.children[0]), (*this)(e.children[1]))};
    }
    if (e.kind != ExpressionKind::run) return {(*this)(e)};
    const auto first = last_index(e.children[0]);
    const auto last = last_index(e.children[1]);
    if (!first || !last || *last >= *first + most_written)
        return {(*this)(e.children[0]), symbol("…"), (*this)(e.children[1])};
    std::vector<Formula> members;
    Expression member = e.children[0];
    for (std::size_t i = *first; i <= *last; ++i) {
        member.children.back().name = std::to_string(i);
        members.push_back((*this)(member));
    }
    return members;
}

/// (t_i) with the conditions on i below it.
Formula StatementFormulas::family(const Expression& e) {
    const Formula i = symbol(e.name);
    const std::vector<Expression>& from = e.groups[0];
    std::vector<Formula> conditions{from.size() == 2 ? relation("≤", {(*this)(from[0]), i, (*this)(from[1])})
                                                     : relation("∈", {i, (*this)(from[0])})};
    for (const Expression& excluded : e.groups[1])
        conditions.push_back(relation("≠", {i, (*this)(excluded)}));
    for (const Expression& excluded : e.groups[2])
        conditions.push_back(relation("∉", {i, (*this)(excluded)}));
    return index(tuple({(*this)(e.children[0])}), list_of(std::move(conditions)));
}

Formula StatementFormulas::range(const proofs::Range& range) {
    const auto first = small_integer(range.first);
    const auto last = small_integer(range.last);
    std::vector<Formula> values;
    if (first && last && *last < *first + most_written) {
        for (std::size_t i = *first; i <= *last; ++i) values.push_back(number(i));
    } else {
        values = {(*this)(range.first), symbol("…"), (*this)(range.last)};
    }
    return equation({symbol(range.name), list_of(std::move(values))});
}

const proofs::Statement* StatementFormulas::clause(std::string_view name) const {
    using proofs::StatementKind;
    for (const proofs::Statement& line : block_.statements) {
        const bool names_it = line.kind == StatementKind::raise        ? line.names[1] == name
                              : line.kind == StatementKind::polynomial ? line.names[0] == name
                              : line.kind == StatementKind::map
                                  ? std::ranges::find(line.names, name) != line.names.end()
                              : line.kind == StatementKind::let ? line.sides[0].name == name
                                                                : false;
        if (names_it) return &line;
    }
    return nullptr;
}

bool StatementFormulas::takes_directions(std::string_view map) const {
    const proofs::Statement* line = clause(map);
    if (!line) return false;
    if (line->kind == proofs::StatementKind::raise) return takes_directions(line->names[0]);
    if (line->kind == proofs::StatementKind::polynomial)
        return line->names.size() > 2 && line->expressions.size() == 1;
    return !line->dimension.empty() && small_integer(line->dimension[0]) != 1U;
}

}  // namespace blossom::worked
