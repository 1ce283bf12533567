#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include "language/functions.hpp"
#include "grounder.hpp"

namespace blossom::proofs {

namespace {

constexpr std::size_t deepest = 1000;
/// What grounding one expression costs, in term operations of an expansion.
constexpr std::size_t steps_an_expression = 20;

/// Counts how deep grounding is, abbreviations that refer to each other included.
class Depth {
public:
    Depth(std::size_t& depth, std::size_t offset) : depth_(depth) {
        if (depth_ == deepest) {
            throw Error(ErrorCode::limit_exceeded,
                        "the depth of the expression, abbreviations included, exceeds the limit " +
                            std::to_string(deepest),
                        "", offset);
        }
        ++depth_;
    }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;
    Depth(Depth&&) = delete;
    Depth& operator=(Depth&&) = delete;
    ~Depth() { --depth_; }

private:
    std::size_t& depth_;
};

}  // namespace

NodeId Grounder::scalar(const Expression& e) {
    const Value result = value(e);
    if (const NodeId* id = std::get_if<NodeId>(&result)) return *id;
    refuse("a point, vector or pair found, expected a number", e.offset);
}

Grounder::Value Grounder::value(const Expression& e) {
    const Depth depth(depth_, e.offset);
    spend(steps_an_expression, e.offset);
    switch (e.kind) {
        case ExpressionKind::number:
            return constant(parse_rational(e.name, limits_));
        case ExpressionKind::name:
            return name(e);
        case ExpressionKind::negative:
            return scaled(constant(-1), value(e.children[0]));
        case ExpressionKind::power:
            return power(e);
        case ExpressionKind::pair:
            return NodeArgument{{scalar(e.children[0])}, scalar(e.children[1])};
        case ExpressionKind::call:
            return call(e);
        case ExpressionKind::value:
        case ExpressionKind::blossom:
            return application(e);
        case ExpressionKind::copies:
        case ExpressionKind::run:
        case ExpressionKind::family:
            refuse("copies, runs and families stand among the arguments of a blossom only", e.offset);
        default:
            return binary(e);
    }
}

NodeArgument Grounder::as_argument(const Value& value, std::size_t dimension) {
    if (const auto* argument = std::get_if<NodeArgument>(&value)) return *argument;
    return {std::vector<NodeId>(dimension, std::get<NodeId>(value)), constant(1)};
}

/// The sum; when an argument with a mass is among the values, numbers are points of the affine line.
Grounder::Value Grounder::sum_of(const Expression& e, std::vector<Value> values) {
    const auto argument =
        std::ranges::find_if(values, [](const Value& v) { return std::holds_alternative<NodeArgument>(v); });
    std::vector<NodeId> masses;
    if (argument == values.end()) {
        for (const Value& value : values) masses.push_back(std::get<NodeId>(value));
        return add(std::move(masses));
    }
    const std::size_t dimension = std::get<NodeArgument>(*argument).coordinates.size();
    std::vector<std::vector<NodeId>> coordinates(dimension);
    for (const Value& value : values) {
        const bool number = std::holds_alternative<NodeId>(value);
        const NodeArgument summand = as_argument(value, dimension);
        if ((number && dimension != 1) || summand.coordinates.size() != dimension) {
            refuse("what is added here has different dimensions", e.offset);
        }
        for (std::size_t i = 0; i < dimension; ++i) coordinates[i].push_back(summand.coordinates[i]);
        masses.push_back(summand.mass);
    }
    NodeArgument result{{}, add(std::move(masses))};
    for (auto& summands : coordinates) result.coordinates.push_back(add(std::move(summands)));
    return result;
}

Grounder::Value Grounder::scaled(NodeId factor, const Value& value) {
    if (const NodeId* id = std::get_if<NodeId>(&value)) return multiply({factor, *id});
    NodeArgument result = std::get<NodeArgument>(value);
    for (NodeId& coordinate : result.coordinates) coordinate = multiply({factor, coordinate});
    result.mass = multiply({factor, result.mass});
    return result;
}

Grounder::Value Grounder::binary(const Expression& e) {
    const Value left = value(e.children[0]);
    const Value right = value(e.children[1]);
    if (e.kind == ExpressionKind::sum) return sum_of(e, {left, right});
    if (e.kind == ExpressionKind::difference) return sum_of(e, {left, scaled(constant(-1), right)});
    const NodeId* a = std::get_if<NodeId>(&left);
    const NodeId* b = std::get_if<NodeId>(&right);
    if (e.kind == ExpressionKind::product) {
        if (a) return scaled(*a, right);
        if (b) return scaled(*b, left);
        refuse("two points or vectors cannot be multiplied", e.offset);
    }
    if (!b) refuse("a point or vector cannot divide", e.children[1].offset);
    if (a) return divide(*a, *b, e.children[1].offset);
    return scaled(divide(constant(1), *b, e.children[1].offset), left);
}

NodeId Grounder::power(const Expression& e) {
    const NodeId base = scalar(e.children[0]);
    const long long exponent = integer(e.children[1]);
    if (exponent >= 0) return raise(base, static_cast<std::size_t>(exponent), e.offset);
    return divide(constant(1), raise(base, static_cast<std::size_t>(-(exponent + 1)) + 1, e.offset),
                  e.offset);
}

Grounder::Value Grounder::name(const Expression& e) {
    if (e.children.empty()) {
        if (const Bound* value = bound(e.name)) {
            if (const long long* number = std::get_if<long long>(value)) return constant(*number);
            refuse(quoted(e.name) + " is a set, expected a number", e.offset);
        }
        if (e.name == "delta") return NodeArgument{{constant(1)}, constant(0)};
        const auto local = local_symbols_.find(e.name);
        if (local != local_symbols_.end()) return symbol_node(local->second);
    }
    if (e.children.empty() && maps_.contains(e.name)) {
        refuse(quoted(e.name) + " is a map, expected an expression such as " + e.name + "(t) or " + e.name +
                   "[...]",
               e.offset);
    }
    const std::string full = full_name(e);
    if (lets_.contains(e.name)) return let_value(full, e);
    const auto space = spaces_.find(e.name);
    if (space == spaces_.end()) return symbol_node(scalar_symbol(e));
    NodeArgument result{{}, constant(space->second.mass)};
    for (std::size_t i = 1; i <= space->second.dimension; ++i) {
        result.coordinates.push_back(symbol_node(symbol(full + "." + std::to_string(i), false)));
    }
    return result;
}

std::size_t Grounder::scalar_symbol(const Expression& name) {
    if (name.kind != ExpressionKind::name) refuse("the name of a variable is expected here", name.offset);
    return symbol(full_name(name), false);
}

/// The abbreviation whose indices fit, the first of several: an index that is a name not bound before stands
/// for any integer, every other one for its value. A name that no line fits is a variable.
Grounder::Value Grounder::let_value(const std::string& full, const Expression& e) {
    const auto known = let_values_.find(full);
    if (known != let_values_.end()) return known->second;
    if (!open_lets_.insert(full).second) refuse("the abbreviation " + full + " refers to itself", e.offset);
    std::vector<long long> indices;
    indices.reserve(e.children.size());
    for (const Expression& index : e.children) indices.push_back(integer(index));
    const auto hidden = std::exchange(bound_, parameters_);
    std::optional<Value> result;
    for (const Statement* statement : lets_[e.name]) {
        const auto& patterns = statement->sides[0].children;
        bound_ = parameters_;
        bool fits = patterns.size() == indices.size();
        for (std::size_t i = 0; fits && i < indices.size(); ++i) {
            const Expression& pattern = patterns[i];
            const bool any =
                pattern.kind == ExpressionKind::name && pattern.children.empty() && !bound(pattern.name);
            if (any) bound_[pattern.name] = indices[i];
            fits = any || integer(pattern) == indices[i];
        }
        if (!fits) continue;
        result = value(statement->sides[1]);
        break;
    }
    bound_ = hidden;
    open_lets_.erase(full);
    if (!result) result = symbol_node(symbol(full, false));
    return let_values_[full] = *result;
}

Grounder::Value Grounder::call(const Expression& e) {
    const Function& function = *find_function(e.name);
    if (e.children.size() < function.least || e.children.size() > function.most) {
        throw Error(
            ErrorCode::wrong_arity,
            std::to_string(e.children.size()) + " arguments found, expected " + std::string(function.form),
            "", e.offset);
    }
    if (e.name == "sum") return sum_of(e, over_range(e));
    if (e.name == "size") return constant(set_of(e.children[0]).size());
    if (e.name == "bernstein") return bernstein(e);
    if (e.name == "factorial") {
        const std::size_t n = count(e.children[0]);
        spend(n, e.offset);
        return constant(factorial(n));
    }
    if (e.name == "binomial") {
        const std::size_t n = count(e.children[0]);
        const long long k = integer(e.children[1]);
        spend(n, e.offset);
        return constant(k < 0 ? Integer(0) : binomial(n, static_cast<std::size_t>(k)));
    }
    if (e.name == "subsets" || e.name == "without") {
        refuse("a set found, expected a number", e.offset);
    }
    std::vector<Value> values = over_range(e);
    if (e.name == "mean") {
        if (values.empty()) refuse("the mean of nothing is not defined", e.offset);
        const NodeId weight = constant(Rational(1, values.size()));
        return scaled(weight, sum_of(e, std::move(values)));
    }
    std::vector<NodeId> factors;
    for (const Value& value : values) {
        const NodeId* factor = std::get_if<NodeId>(&value);
        if (!factor) refuse("points and vectors cannot be multiplied", e.offset);
        factors.push_back(*factor);
    }
    return multiply(std::move(factors));
}

/// C(n, i) t^i (1 - t)^(n - i), zero for i outside 0..n.
NodeId Grounder::bernstein(const Expression& e) {
    const long long i = integer(e.children[0]);
    const std::size_t n = count(e.children[1]);
    const NodeId t = scalar(e.children[2]);
    if (i < 0 || static_cast<std::size_t>(i) > n) return constant(0);
    const auto k = static_cast<std::size_t>(i);
    const NodeId rest = add({constant(1), multiply({constant(-1), t})});
    return multiply({constant(binomial(n, k)), raise(t, k, e.offset), raise(rest, n - k, e.offset)});
}

}  // namespace blossom::proofs
