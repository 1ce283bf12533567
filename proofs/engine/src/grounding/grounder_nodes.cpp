#include <blossom/rational/error.hpp>

#include <algorithm>

#include <blossom/proofs/expansion.hpp>

#include "grounder.hpp"

/// Construction of the nodes of a ground expression. Constants are computed immediately, so that bounds,
/// indices and exponents are numbers.

namespace blossom::proofs {

const Rational* Grounder::constant_value(NodeId id) const {
    const Node& node = block_.nodes[id];
    return node.kind == NodeKind::constant ? &node.value : nullptr;
}

bool Grounder::is_one(NodeId id) const {
    if (const Rational* value = constant_value(id)) return *value == Rational(1);
    Expander expand(block_, limits_);
    const Fraction mass = expand(id);
    return mass.denominator.empty() && mass.numerator == SparsePolynomial(1);
}

void Grounder::spend(std::size_t steps, std::size_t offset) {
    steps_ += steps;
    if (steps_ <= limits_.expansion_work) return;
    throw limit_error("the number of steps to write the statement out exceeds", "expansion_work",
                      limits_.expansion_work, {}, offset);
}

NodeId Grounder::push(Node node, std::size_t offset) {
    require_within(block_.nodes.size() + 1, limits_.numbers, "numbers", "the size of the expanded statement");
    node.offset = offset;
    block_.nodes.push_back(std::move(node));
    return block_.nodes.size() - 1;
}

NodeId Grounder::constant(Rational value) {
    const auto known = constants_.find(value);
    if (known != constants_.end()) return known->second;
    const NodeId id = push({NodeKind::constant, value, 0, {}, 0});
    constants_.emplace(std::move(value), id);
    return id;
}

std::size_t Grounder::symbol(const std::string& key, Symbol symbol) {
    const auto known = symbols_.find(key);
    if (known != symbols_.end()) return known->second;
    require_within(block_.symbols.size() + 1, limits_.variables, "variables", "the number of variables");
    block_.symbols.push_back(std::move(symbol));
    return symbols_[key] = block_.symbols.size() - 1;
}

NodeId Grounder::symbol_node(std::size_t number) { return push({NodeKind::symbol, {}, number, {}, 0}); }

NodeId Grounder::add(std::vector<NodeId> operands) {
    Rational sum;
    std::erase_if(operands, [&](NodeId id) {
        const Rational* value = constant_value(id);
        if (value) sum += *value;
        return value != nullptr;
    });
    if (operands.empty()) return constant(sum);
    if (!sum.is_zero()) operands.push_back(constant(sum));
    return operands.size() == 1 ? operands.front() : push({NodeKind::sum, {}, 0, std::move(operands), 0});
}

NodeId Grounder::multiply(std::vector<NodeId> operands) {
    Rational product = 1;
    std::erase_if(operands, [&](NodeId id) {
        const Rational* value = constant_value(id);
        if (value) product *= *value;
        return value != nullptr;
    });
    if (operands.empty()) return constant(product);
    if (product != Rational(1)) operands.push_back(constant(product));
    return operands.size() == 1 ? operands.front() : push({NodeKind::product, {}, 0, std::move(operands), 0});
}

NodeId Grounder::divide(NodeId a, NodeId b, std::size_t offset) {
    if (const Rational* divisor = constant_value(b)) {
        if (divisor->is_zero())
            throw Error(ErrorCode::division_by_zero, "the denominator is zero", {}, offset);
        return multiply({a, constant(Rational(1) / *divisor)});
    }
    return push({NodeKind::quotient, {}, 0, {a, b}, 0}, offset);
}

NodeId Grounder::raise(NodeId base, std::size_t exponent, std::size_t offset) {
    try {
        require_within(exponent, limits_.degree, "degree", "the exponent");
        if (const Rational* value = constant_value(base)) {
            require_result_bits(
                exponent * std::max(value->numerator().bit_length(), value->denominator().bit_length()),
                limits_);
            spend(exponent, offset);
            return constant(pow(*value, exponent));
        }
    } catch (const Error& error) {
        throw error.at(Place()).at(offset);
    }
    // The power 0 is kept, because it is 1 only where its base is defined.
    return exponent == 1 ? base : push({NodeKind::power, {}, exponent, {base}, 0});
}

/// The polynomial as a sum of products; variable i is symbol i.
NodeId Grounder::polynomial_node(const SparsePolynomial& polynomial) {
    std::vector<NodeId> terms;
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        std::vector<NodeId> factors{constant(polynomial.coefficient(i))};
        for (std::size_t j = 0; j < polynomial.variables(); ++j) {
            const std::size_t exponent = polynomial.exponent(i, j);
            if (exponent != 0) factors.push_back(raise(symbol_node(j), exponent, 0));
        }
        terms.push_back(multiply(std::move(factors)));
    }
    return add(std::move(terms));
}

}  // namespace blossom::proofs
