#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include <blossom/proofs/expansion.hpp>

#include "grounder.hpp"

/// Declarations of maps.

namespace blossom::proofs {

namespace {

/// Appends to `result` all exponents that extend `used` to `dimension` variables with a sum of at most `left`
/// for the new ones.
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

std::size_t total(const std::vector<std::size_t>& exponents) {
    std::size_t sum = 0;
    for (const std::size_t exponent : exponents) sum += exponent;
    return sum;
}

/// n! / (alpha_1! ... alpha_s! (n - |alpha|)!)
Integer multinomial(const std::vector<std::size_t>& exponents, std::size_t n) {
    Integer result = 1;
    for (const std::size_t exponent : exponents) {
        result *= binomial(n, exponent);
        n -= exponent;
    }
    return result;
}

/// The terms of a polynomial in which the exponents of `symbols` are `powers`, without these symbols.
SparsePolynomial coefficient_of(const SparsePolynomial& polynomial, const std::vector<std::size_t>& symbols,
                                const std::vector<std::size_t>& powers) {
    std::vector<SparsePolynomial> terms;
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        std::vector<std::size_t> term(polynomial.variables());
        for (std::size_t j = 0; j < term.size(); ++j) term[j] = polynomial.exponent(i, j);
        bool belongs = true;
        for (std::size_t j = 0; j < symbols.size(); ++j) {
            belongs = belongs && polynomial.exponent(i, symbols[j]) == powers[j];
            if (symbols[j] < term.size()) term[symbols[j]] = 0;
        }
        if (belongs) terms.push_back(SparsePolynomial::term(polynomial.coefficient(i), term));
    }
    return sum(terms);
}

bool contains_any(const SparsePolynomial& polynomial, const std::vector<std::size_t>& symbols) {
    return std::ranges::any_of(symbols, [&](std::size_t symbol) { return polynomial.degree_in(symbol) > 0; });
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

void Grounder::add_map(GroundMap map) {
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
    }
    if (number_of_coefficients(result) > limits_.variables) {
        throw limit_error("the number of coefficients of the map exceeds", "variables", limits_.variables, {},
                          statement.offset);
    }
    return result;
}

void Grounder::declare_map(const Statement& statement) {
    for (const std::string& name : statement.names) {
        GroundMap map{name, directions(statement), {}, {}, {}};
        if (!statement.net.empty()) {
            add_net(statement, map);
        } else {
            for (const auto& exponents : monomials(map.directions)) {
                std::string index = name;
                for (const std::size_t exponent : exponents) index += "." + std::to_string(exponent);
                map.coefficients.push_back(symbol_node(symbol(index, {index, true})));
            }
        }
        add_map(std::move(map));
    }
}

/// `map q degree n on simplex s net c over P_0, ..., P_s`: in barycentric coordinates over the frame, by
/// Cramer's rule, the coefficients are control points times multinomial coefficients.
void Grounder::add_net(const Statement& statement, GroundMap& map) {
    const Direction direction = map.directions[0];
    if (map.directions.size() != 1 || statement.frame.size() != direction.dimension + 1) {
        refuse("a map of one degree on a simplex of dimension " + std::to_string(direction.dimension) +
                   " has a net over " + std::to_string(direction.dimension + 1) + " points",
               statement.offset);
    }
    std::vector<std::vector<NodeId>> frame;
    for (const Expression& point : statement.frame) {
        const NodeArgument corner = argument(point, direction.dimension);
        if (!is_one(corner.mass)) refuse("a point of the frame has mass 1", point.offset);
        frame.push_back(corner.coordinates);
        frame.back().push_back(corner.mass);
    }
    const NodeId whole = determinant(frame);
    const Rational* value = constant_value(whole);
    if (value && value->is_zero())
        refuse("the points of the frame are affinely dependent", statement.frame[0].offset);
    // The barycentric coordinate of P_j is the determinant with the argument in its column, which is linear
    // in the argument: its coefficients are cofactors of the frame.
    for (std::size_t j = 0; j <= direction.dimension; ++j) {
        map.barycentric.emplace_back();
        for (std::size_t i = 0; i <= direction.dimension; ++i) {
            auto replaced = frame;
            for (std::size_t k = 0; k <= direction.dimension; ++k) replaced[j][k] = constant(k == i ? 1 : 0);
            map.barycentric.back().push_back(divide(determinant(replaced), whole, statement.offset));
        }
    }
    if (!constant_value(whole)) map.conditions.push_back(whole);
    for (const auto& exponents : monomials(direction)) {
        Expression name{ExpressionKind::name, statement.offset, statement.net, {}, {}};
        std::vector<std::size_t> index = exponents;
        if (direction.dimension > 1) index.insert(index.begin(), direction.degree - total(exponents));
        for (const std::size_t i : index)
            name.children.push_back({ExpressionKind::number, statement.offset, std::to_string(i), {}, {}});
        const NodeId scale = constant(Rational(multinomial(exponents, direction.degree)));
        const NodeId control_point = scalar(name);
        const Node& node = block_.nodes[control_point];
        if (node.kind == NodeKind::symbol) block_.symbols[node.index].is_control_point = true;
        map.coefficients.push_back(multiply({scale, control_point}));
    }
}

/// `poly P(t) degree n = expression`: the coefficients of the powers of t in the expanded expression,
/// including t in abbreviations.
void Grounder::declare_polynomial(const Statement& statement) {
    const std::size_t variables = statement.names.size() - 1;
    GroundMap map{statement.names[0], {}, {}, {}, {}};
    for (const Expression& degree : statement.expressions) map.directions.push_back({count(degree), 1});
    if (map.directions.size() == 1) map.directions[0].dimension = variables;
    if (map.directions.size() != 1 && map.directions.size() != variables) {
        throw Error(ErrorCode::wrong_arity,
                    std::to_string(variables) + " variables have one degree together or one each", {},
                    statement.offset);
    }
    std::vector<std::size_t> symbols;
    std::optional<Variables> taken(std::in_place, *this);
    for (std::size_t i = 1; i <= variables; ++i) {
        symbols.push_back(bound_symbol(statement.names[i]));
        variables_[statement.names[i]] = symbol_node(symbols.back());
    }
    const NodeId body = scalar(statement.sides[0]);
    taken.reset();
    Expander expander(block_, limits_);
    const auto [numerator, denominator] = expander(body);
    std::vector<NodeId> divisors;
    for (const auto& [factor, exponent] : denominator) {
        const SparsePolynomial& divisor = expander.field().factors()[factor];
        if (contains_any(divisor, symbols))
            refuse("the expression is not a polynomial", statement.sides[0].offset);
        divisors.push_back(raise(polynomial_node(divisor), exponent, statement.offset));
    }
    for (const NodeId divisor : divisors_below(block_, {body})) {
        for (const auto& [factor, exponent] :
             expander.field().factorise(expander(divisor).numerator).factors) {
            const SparsePolynomial condition = expander.field().factors()[factor];
            if (!contains_any(condition, symbols)) map.conditions.push_back(polynomial_node(condition));
        }
    }
    const NodeId divisor = multiply(std::move(divisors));
    std::size_t used = 0;
    for (const auto& powers : monomials(map.directions)) {
        const SparsePolynomial coefficient = coefficient_of(numerator, symbols, powers);
        used += coefficient.size();
        map.coefficients.push_back(divide(polynomial_node(coefficient), divisor, statement.sides[0].offset));
    }
    if (used != numerator.size()) {
        throw Error(ErrorCode::degree_too_low, "the polynomial has a higher degree than declared", {},
                    statement.sides[0].offset);
    }
    add_map(std::move(map));
}

/// `raise p to m as q`, with one degree per direction. The homogeneous form is multiplied by a power of the
/// mass; for a net, the mass is the sum of the barycentric coordinates.
void Grounder::declare_raised(const Statement& statement) {
    const auto source = maps_.find(statement.names[0]);
    if (source == maps_.end()) {
        refuse("the map " + quoted(statement.names[0]) + " is declared below the line that raises it",
               statement.offset);
    }
    const GroundMap before = block_.maps[source->second];
    GroundMap map = before;
    map.name = statement.names[1];
    if (statement.expressions.size() != map.directions.size()) {
        throw Error(ErrorCode::wrong_arity,
                    std::to_string(statement.expressions.size()) + " degrees found, " + before.name +
                        " has " + std::to_string(map.directions.size()),
                    {}, statement.offset);
    }
    for (std::size_t i = 0; i < map.directions.size(); ++i) {
        const std::size_t degree = count(statement.expressions[i]);
        if (degree < map.directions[i].degree) {
            throw Error(ErrorCode::degree_too_low,
                        "the degree " + std::to_string(degree) + " is lower than that of " + before.name, {},
                        statement.expressions[i].offset);
        }
        map.directions[i].degree = degree;
    }
    if (number_of_coefficients(map.directions) > limits_.variables) {
        throw limit_error("the number of coefficients of the map exceeds", "variables", limits_.variables, {},
                          statement.offset);
    }
    const auto known = monomials(before.directions);
    const std::size_t steps =
        map.barycentric.empty() ? 0 : map.directions[0].degree - before.directions[0].degree;
    std::map<std::vector<std::size_t>, std::vector<NodeId>> summands;
    for (std::size_t i = 0; i < known.size(); ++i) {
        for (const auto& further : monomials({steps, known[i].size()})) {
            std::vector<std::size_t> exponents = known[i];
            for (std::size_t j = 0; j < exponents.size(); ++j) exponents[j] += further[j];
            const NodeId scale = constant(Rational(multinomial(further, steps)));
            summands[exponents].push_back(multiply({scale, before.coefficients[i]}));
        }
    }
    map.coefficients.clear();
    for (const auto& exponents : monomials(map.directions))
        map.coefficients.push_back(add(summands[exponents]));
    add_map(std::move(map));
}

}  // namespace blossom::proofs
