#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include <blossom/proofs/expansion.hpp>

#include "language/functions.hpp"
#include "grounder.hpp"

/// Declarations of maps and their applications.

namespace blossom::proofs {

namespace {

/// Appends to `result` all exponents of `dimension - used.size()` more variables with sum at most `left`.
void append_monomials(std::vector<std::size_t>& used, std::size_t dimension, std::size_t left,
                      std::vector<std::vector<std::size_t>>& result) {
    if (used.size() == dimension) {
        result.push_back(used);
        return;
    }
    for (std::size_t i = 0; i <= left; ++i) {
        used.push_back(i);
        append_monomials(used, dimension, left - i, result);
        used.pop_back();
    }
}

std::size_t number_of_coefficients(const std::vector<Direction>& directions) {
    Integer number = 1;
    for (const auto& [degree, dimension] : directions) number *= binomial(degree + dimension, dimension);
    const auto word = number.to_int64();
    return word ? static_cast<std::size_t>(*word) : std::size_t(-1);
}

}  // namespace

std::vector<std::vector<std::size_t>> monomials(const Direction& direction) {
    std::vector<std::vector<std::size_t>> result;
    std::vector<std::size_t> used;
    append_monomials(used, direction.dimension, direction.degree, result);
    return result;
}

std::vector<std::vector<std::size_t>> monomials(const std::vector<Direction>& directions) {
    std::vector<std::vector<std::size_t>> result{{}};
    for (const Direction& direction : directions) {
        std::vector<std::vector<std::size_t>> longer;
        for (const auto& before : result) {
            for (const auto& further : monomials(direction)) {
                longer.push_back(before);
                longer.back().insert(longer.back().end(), further.begin(), further.end());
            }
        }
        result = std::move(longer);
    }
    return result;
}

void Grounder::require_new(const std::string& name, std::size_t offset) const {
    if (name == "delta" || name == "D" || is_function(name)) {
        refuse(quoted(name) + " is a word of the language and cannot be declared", offset);
    }
    if (maps_.contains(name) || spaces_.contains(name) || bound_.contains(name) || lets_.contains(name)) {
        refuse(quoted(name) + " is declared already", offset);
    }
}

void Grounder::add_map(GroundMap map, std::size_t offset) {
    require_new(map.name, offset);
    maps_[map.name] = block_.maps.size();
    block_.maps.push_back(std::move(map));
}

std::vector<Direction> Grounder::directions(const Statement& statement) {
    std::vector<Direction> result;
    result.reserve(statement.expressions.size());
    for (const Expression& degree : statement.expressions) result.push_back({count(degree), 1});
    if (!statement.dimension.empty()) {
        if (result.size() != 1) refuse("a map on a simplex has one degree", statement.offset);
        result[0].dimension = count(statement.dimension[0]);
        if (result[0].dimension == 0) refuse("the dimension of a simplex is at least 1", statement.offset);
    }
    if (number_of_coefficients(result) > limits_.variables) {
        throw Error(ErrorCode::limit_exceeded,
                    "the number of coefficients of the map exceeds the limit variables = " +
                        std::to_string(limits_.variables),
                    "", statement.offset);
    }
    return result;
}

void Grounder::declare_map(const Statement& statement) {
    for (const std::string& name : statement.names) {
        GroundMap map{name, directions(statement), {}, true};
        for (const auto& exponents : monomials(map.directions)) {
            std::string index = name;
            for (const std::size_t exponent : exponents) index += "." + std::to_string(exponent);
            map.coefficients.push_back(symbol_node(symbol(index, true)));
        }
        add_map(std::move(map), statement.offset);
    }
}

void Grounder::declare_points(const Statement& statement) {
    const std::size_t dimension = count(statement.dimension[0]);
    if (dimension == 0) refuse("the dimension of a point is at least 1", statement.offset);
    for (const Expression& name_or_run : statement.expressions) {
        const Expression& name =
            name_or_run.kind == ExpressionKind::run ? name_or_run.children[0] : name_or_run;
        // Points with indices share their name: each declaration of one must agree with the others.
        const Space space{dimension, statement.kind == StatementKind::point ? 1 : 0};
        const auto known = spaces_.find(name.name);
        if (known == spaces_.end()) require_new(name.name, name.offset);
        spaces_.insert_or_assign(name.name, space);
    }
}

void Grounder::declare_let(const Statement& statement) {
    const Expression& name = statement.sides[0];
    if (name.kind != ExpressionKind::name) refuse("an abbreviation has a name, not a run", name.offset);
    // With an index it is another name: b_0 beside the map b.
    if (name.children.empty() || spaces_.contains(name.name) || bound_.contains(name.name)) {
        require_new(name.name, name.offset);
    }
    lets_[name.name].push_back(&statement);
}

/// `poly P(t) degree n = expression`: the expression, expanded, has the coefficients by powers of t.
void Grounder::declare_polynomial(const Statement& statement) {
    const std::size_t variables = statement.names.size() - 1;
    std::vector<Direction> directions;
    directions.reserve(statement.expressions.size());
    for (const Expression& degree : statement.expressions) directions.push_back({count(degree), 1});
    if (directions.size() == 1) directions[0].dimension = variables;
    if (directions.size() != 1 && directions.size() != variables) {
        throw Error(ErrorCode::wrong_arity,
                    std::to_string(variables) + " variables have one degree together or one each", "",
                    statement.offset);
    }
    std::vector<std::size_t> symbols;
    for (std::size_t i = 1; i <= variables; ++i) {
        const std::string& name = statement.names[i];
        require_new(name, statement.offset);
        symbols.push_back(symbol(statement.names[0] + "(" + name + ")", false));
        local_symbols_[name] = symbols.back();
    }
    const NodeId body = scalar(statement.sides[0]);
    local_symbols_.clear();
    Expander expander(block_, limits_);
    const auto [numerator, denominator] = expander(body);
    GroundMap map{statement.names[0], directions, {}, false};
    std::vector<NodeId> divisors;
    for (const auto& [factor, exponent] : denominator) {
        const SparsePolynomial& divisor = expander.field().factors()[factor];
        for (const std::size_t symbol : symbols) {
            if (divisor.degree_in(symbol) > 0)
                refuse("the expression is not a polynomial", statement.sides[0].offset);
        }
        divisors.push_back(raise(polynomial_node(divisor), exponent, statement.offset));
    }
    const NodeId divisor = multiply(std::move(divisors));
    std::size_t used = 0;
    for (const auto& powers : monomials(directions)) {
        std::vector<SparsePolynomial> terms;
        for (std::size_t i = 0; i < numerator.size(); ++i) {
            std::vector<std::size_t> term(numerator.variables());
            for (std::size_t j = 0; j < term.size(); ++j) term[j] = numerator.exponent(i, j);
            bool belongs = true;
            for (std::size_t j = 0; j < symbols.size(); ++j) {
                belongs = belongs && numerator.exponent(i, symbols[j]) == powers[j];
                if (symbols[j] < term.size()) term[symbols[j]] = 0;
            }
            if (belongs) terms.push_back(SparsePolynomial::term(numerator.coefficient(i), term));
        }
        used += terms.size();
        const NodeId coefficient = polynomial_node(sum(terms));
        map.coefficients.push_back(divide(coefficient, divisor, statement.sides[0].offset));
    }
    if (used != numerator.size()) {
        throw Error(ErrorCode::degree_too_low, "the polynomial has a higher degree than declared", "",
                    statement.sides[0].offset);
    }
    add_map(std::move(map), statement.offset);
}

void Grounder::declare_raised(const Statement& statement) {
    const auto source = maps_.find(statement.names[0]);
    if (source == maps_.end()) refuse("there is no map " + quoted(statement.names[0]), statement.offset);
    GroundMap map = block_.maps[source->second];
    const std::vector<NodeId> coefficients = map.coefficients;
    if (map.directions.size() != 1) refuse("a tensor-product map is not raised as a whole", statement.offset);
    const auto before = monomials(map.directions[0]);
    const std::size_t degree = count(statement.expressions[0]);
    if (degree < map.directions[0].degree) {
        throw Error(ErrorCode::degree_too_low,
                    "the degree " + std::to_string(degree) + " is lower than that of " + map.name, "",
                    statement.expressions[0].offset);
    }
    map.directions[0].degree = degree;
    map.name = statement.names[1];
    map.arbitrary = false;
    map.coefficients.clear();
    for (const auto& exponents : monomials(map.directions[0])) {
        const auto known = std::ranges::find(before, exponents);
        map.coefficients.push_back(known == before.end()
                                       ? constant(0)
                                       : coefficients[static_cast<std::size_t>(known - before.begin())]);
    }
    add_map(std::move(map), statement.offset);
}

std::size_t Grounder::map_named(const Expression& e) const {
    const auto found = maps_.find(e.name);
    if (found == maps_.end()) {
        refuse("there is no map or function " + quoted(e.name) + "; declare it, as in \"map " + e.name +
                   " degree n\"",
               e.offset);
    }
    return found->second;
}

NodeArgument Grounder::lifted(const Value& value, const Direction& direction, std::size_t offset) {
    const bool number = std::holds_alternative<NodeId>(value);
    NodeArgument argument = as_argument(value, 1);
    if ((number && direction.dimension != 1) || argument.coordinates.size() != direction.dimension) {
        refuse("an argument of dimension " + std::to_string(argument.coordinates.size()) +
                   " found, expected one of dimension " + std::to_string(direction.dimension),
               offset);
    }
    return argument;
}

NodeArgument Grounder::argument(const Expression& e, const Direction& direction) {
    return lifted(value(e), direction, e.offset);
}

void Grounder::add_arguments(const Expression& e, const Direction& direction,
                             std::vector<NodeArgument>& arguments) {
    if (e.kind == ExpressionKind::copies) {
        const std::size_t copies = count(e.children[1]);
        arguments.insert(arguments.end(), copies, argument(e.children[0], direction));
    } else if (e.kind == ExpressionKind::run) {
        for (const Expression& member : run_members(e)) arguments.push_back(argument(member, direction));
    } else if (e.kind == ExpressionKind::family) {
        for (const long long i : family_indices(e)) {
            const Binding binding(*this, e.name, i);
            arguments.push_back(argument(e.children[0], direction));
        }
    } else {
        arguments.push_back(argument(e, direction));
    }
}

NodeId Grounder::application(const Expression& e) {
    Application result{map_named(e), e.kind == ExpressionKind::blossom, {}, {}, e.offset};
    const std::vector<Direction> directions = block_.maps[result.map].directions;
    const auto wrong_arity = [&](std::size_t found, std::size_t expected, const std::string& what) {
        throw Error(
            ErrorCode::wrong_arity,
            std::to_string(found) + " " + what + " found, " + e.name + " expects " + std::to_string(expected),
            "", e.offset);
    };
    if (result.polar) {
        if (e.groups.size() != directions.size())
            wrong_arity(e.groups.size(), directions.size(), "directions of arguments");
        for (std::size_t i = 0; i < directions.size(); ++i) {
            result.arguments.emplace_back();
            for (const Expression& given : e.groups[i])
                add_arguments(given, directions[i], result.arguments[i]);
            if (result.arguments[i].size() != directions[i].degree)
                wrong_arity(result.arguments[i].size(), directions[i].degree, "arguments of the blossom");
        }
    } else {
        const auto& given = e.groups[0];
        const bool coordinates =
            directions.size() == 1 && directions[0].dimension > 1 && given.size() == directions[0].dimension;
        if (coordinates) {
            NodeArgument point{{}, constant(1)};
            for (const Expression& coordinate : given) point.coordinates.push_back(scalar(coordinate));
            result.arguments.push_back({std::move(point)});
        } else {
            if (given.size() != directions.size()) wrong_arity(given.size(), directions.size(), "arguments");
            for (std::size_t i = 0; i < given.size(); ++i)
                result.arguments.push_back({argument(given[i], directions[i])});
        }
        for (const Expression& order : e.children) result.orders.push_back(count(order));
        if (result.orders.empty()) result.orders.assign(directions.size(), 0);
        if (result.orders.size() != directions.size())
            wrong_arity(result.orders.size(), directions.size(), "orders of a derivative");
        for (std::size_t i = 0; i < directions.size(); ++i) {
            if (result.orders[i] == 0) continue;
            const Rational* mass = constant_value(result.arguments[i][0].mass);
            if (directions[i].dimension != 1 || !mass || *mass != Rational(1))
                refuse("a derivative is taken of a map of one variable, at a number", e.offset);
        }
    }
    block_.applications.push_back(std::move(result));
    return push({NodeKind::application, {}, block_.applications.size() - 1, {}, 0}, e.offset);
}

}  // namespace blossom::proofs
