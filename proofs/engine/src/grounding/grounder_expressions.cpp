#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include "grounder.hpp"

namespace blossom::proofs {

namespace {

constexpr std::size_t deepest = 1000;
/// The cost of grounding one expression, in term operations of an expansion.
constexpr std::size_t steps_an_expression = 20;

void require_depth(std::size_t depth, std::size_t offset) {
    if (depth <= deepest) return;
    throw Error(
        ErrorCode::limit_exceeded,
        "the depth of the expression, abbreviations included, exceeds the limit " + std::to_string(deepest),
        {}, offset);
}

/// Counts nested calls of grounding, including those of abbreviations that use each other.
class Depth {
public:
    Depth(std::size_t& depth, std::size_t offset) : depth_(depth) {
        require_depth(depth_ + 1, offset);
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

void Grounder::begin(const Block& block) {
    text_ = &block;
    parameters_ = bound_;
    names_.emplace(block);
    kinds_.emplace(block, *names_, [this](const Expression& e) {
        const std::size_t dimension = count(e);
        if (dimension == 0) refuse("a dimension is at least 1", e.offset);
        require_within(dimension, limits_.variables, "variables", "the dimension");
        return dimension;
    });
}

NodeId Grounder::scalar(const Expression& e) {
    const Value result = value(e);
    if (const NodeId* id = std::get_if<NodeId>(&result)) return *id;
    refuse("a point, vector or pair found, expected a number", e.offset);
}

Value Grounder::value(const Expression& e) {
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
        case ExpressionKind::point: {
            NodeArgument point{{}, constant(1)};
            for (const Expression& coordinate : e.children) point.coordinates.push_back(scalar(coordinate));
            return point;
        }
        case ExpressionKind::call:
            return call(e);
        case ExpressionKind::value:
        case ExpressionKind::blossom:
            return application(e);
        case ExpressionKind::derivative:
            return derivative(e);
        case ExpressionKind::comparison:
        case ExpressionKind::copies:
        case ExpressionKind::run:
        case ExpressionKind::family:
            break;
        case ExpressionKind::sum:
            return sum(e);
        case ExpressionKind::product:
            return product(e);
    }
    refuse("this stands in a condition or among the arguments of a blossom only", e.offset);
}

/// A number as the point of the line with mass 1.
NodeArgument Grounder::as_argument(const Value& value) {
    if (const auto* argument = std::get_if<NodeArgument>(&value)) return *argument;
    return {{std::get<NodeId>(value)}, constant(1)};
}

Value Grounder::zero_of(const Kind& kind) {
    if (!kind.is_geometric()) return constant(0);
    return NodeArgument{std::vector<NodeId>(kind.dimension, constant(0)), constant(0)};
}

/// The sum of values of one kind, which is the zero of that kind if there are none. Coordinates and masses
/// are added.
Value Grounder::sum_of(std::vector<Value> values, const Kind& kind) {
    const bool geometric =
        std::ranges::any_of(values, [](const Value& v) { return std::holds_alternative<NodeArgument>(v); });
    if (values.empty()) return zero_of(kind);
    std::vector<NodeId> masses;
    if (!geometric) {
        for (const Value& value : values) masses.push_back(std::get<NodeId>(value));
        return add(std::move(masses));
    }
    std::vector<std::vector<NodeId>> coordinates;
    for (const Value& value : values) {
        const NodeArgument summand = as_argument(value);
        coordinates.resize(summand.coordinates.size());
        for (std::size_t i = 0; i < coordinates.size(); ++i) coordinates[i].push_back(summand.coordinates[i]);
        masses.push_back(summand.mass);
    }
    NodeArgument result{{}, add(std::move(masses))};
    for (auto& summands : coordinates) result.coordinates.push_back(add(std::move(summands)));
    return result;
}

Value Grounder::scaled(NodeId factor, const Value& value) {
    if (const NodeId* id = std::get_if<NodeId>(&value)) return multiply({factor, *id});
    NodeArgument result = std::get<NodeArgument>(value);
    for (NodeId& coordinate : result.coordinates) coordinate = multiply({factor, coordinate});
    result.mass = multiply({factor, result.mass});
    return result;
}

Value Grounder::sum(const Expression& e) {
    std::vector<Value> summands{value(e.children[0])};
    bool geometric = std::holds_alternative<NodeArgument>(summands.front());
    for (std::size_t i = 1; i < e.children.size(); ++i) {
        Value next = value(e.children[i]);
        if (!geometric && std::holds_alternative<NodeArgument>(next)) {
            // All numbers before it together are one point.
            summands = {sum_of(std::move(summands), {})};
            geometric = true;
        } else if (geometric) {
            // A number subtracted from a vector or pair is a point, whose mass is also subtracted.
            next = as_argument(next);
        }
        summands.push_back(e.name[i - 1] == '-' ? scaled(constant(-1), next) : std::move(next));
    }
    return sum_of(std::move(summands), {});
}

Value Grounder::product(const Expression& e) {
    std::vector<NodeId> factors;
    std::optional<NodeArgument> geometric;
    const auto take = [&](Value next) {
        if (const NodeId* factor = std::get_if<NodeId>(&next)) {
            factors.push_back(*factor);
        } else {
            geometric = std::get<NodeArgument>(std::move(next));
        }
    };
    // Each quotient contains the previous ones.
    require_depth(depth_ + static_cast<std::size_t>(std::ranges::count(e.name, '/')), e.offset);
    take(value(e.children[0]));
    for (std::size_t i = 1; i < e.children.size(); ++i) {
        const Expression& child = e.children[i];
        if (e.name[i - 1] == '*') {
            take(value(child));
            continue;
        }
        const NodeId divisor = scalar(child);
        if (geometric) {
            factors.push_back(divide(constant(1), divisor, child.offset));
        } else {
            factors = {divide(multiply(std::move(factors)), divisor, child.offset)};
        }
    }
    const NodeId factor = multiply(std::move(factors));
    return geometric ? scaled(factor, *geometric) : Value(factor);
}

NodeId Grounder::power(const Expression& e) {
    const NodeId base = scalar(e.children[0]);
    const long long exponent = integer(e.children[1]);
    if (exponent >= 0) return raise(base, static_cast<std::size_t>(exponent), e.offset);
    return divide(constant(1), raise(base, static_cast<std::size_t>(-(exponent + 1)) + 1, e.offset),
                  e.offset);
}

/// D(e, t, k)
NodeId Grounder::derivative(const Expression& e) {
    const NodeId body = scalar(e.children[0]);
    const NodeId variable = scalar(e.children[1]);
    const std::size_t order = e.children.size() == 3 ? count(e.children[2]) : 1;
    if (block_.nodes[variable].kind != NodeKind::symbol)
        refuse("a derivative is taken with respect to a variable", e.children[1].offset);
    if (order == 0) return body;
    spend(order, e.offset);
    return push({NodeKind::derivative, {}, block_.nodes[variable].index, {body}, 0, order}, e.offset);
}

}  // namespace blossom::proofs
