#include "ground_formulas.hpp"

#include <blossom/core/maps/argument.hpp>

#include <algorithm>
#include <iterator>

#include "formulas_of_values.hpp"
#include "symbols.hpp"

namespace blossom::worked {

using proofs::NodeKind;

bool is_written(const proofs::GroundBlock& block) {
    const auto one_argument = [](const proofs::GroundMap& map) {
        return map.directions.size() == 1 && map.directions.front().dimension == 1 && map.barycentric.empty();
    };
    const auto is_derivative = [](const proofs::Node& node) { return node.kind == NodeKind::derivative; };
    const auto is_coefficient_name = [&](const proofs::Symbol& symbol) {
        return !symbol.is_coefficient && std::ranges::any_of(block.maps, [&](const proofs::GroundMap& map) {
            return symbol.name.starts_with(map.name + "_");
        });
    };
    return std::ranges::all_of(block.maps, one_argument) &&
           std::ranges::none_of(block.symbols, is_coefficient_name) &&
           std::ranges::none_of(block.nodes, is_derivative);
}

Formula GroundFormulas::symbol_formula(std::size_t i) const {
    const proofs::Symbol& one = block_.symbols[i];
    // "t_1" is the letter t with an index, and "b.1" is a coefficient of b.
    const std::size_t mark = one.name.find(one.is_coefficient ? '.' : '_');
    if (mark == std::string::npos) return symbol(one.name);
    const std::string subscript = one.name.substr(mark + 1);
    const bool digits = std::ranges::all_of(subscript, [](char c) { return c >= '0' && c <= '9'; });
    if (!digits || subscript.size() > 9) return symbol(one.name);
    return index(symbol(one.name.substr(0, mark)), number(std::stoul(subscript)));
}

Formula GroundFormulas::operator()(proofs::NodeId id) {
    const proofs::Node& node = block_.nodes[id];
    switch (node.kind) {
        case NodeKind::constant:
            return number(node.value);
        case NodeKind::symbol:
            return has_values() ? number(values_[node.index]) : symbol_formula(node.index);
        case NodeKind::sum: {
            std::vector<Formula> terms;
            for (const proofs::NodeId operand : node.operands) {
                Formula term = (*this)(operand);
                if (term.kind != FormulaKind::sum) {
                    terms.push_back(std::move(term));
                } else {
                    std::ranges::move(term.parts, std::back_inserter(terms));
                }
            }
            return sum(std::move(terms));
        }
        case NodeKind::product:
            return product_formula(node);
        case NodeKind::quotient:
            return fraction((*this)(node.operands[0]), (*this)(node.operands[1]));
        case NodeKind::power:
            return power((*this)(node.operands[0]), number(node.index));
        case NodeKind::application:
            return application(block_.applications[node.index]);
        case NodeKind::derivative:
            break;
    }
    return {};
}

/// Writes a number as a factor in front, or as a denominator.
Formula GroundFormulas::product_formula(const proofs::Node& node) {
    std::vector<Formula> factors;
    Rational constant(1);
    for (const proofs::NodeId operand : node.operands) {
        const proofs::Node& factor = block_.nodes[operand];
        if (factor.kind == NodeKind::constant) {
            constant *= factor.value;
        } else {
            factors.push_back((*this)(operand));
        }
    }
    const Rational numerator(constant.numerator());
    if (numerator != Rational(1)) factors.insert(factors.begin(), number(numerator));
    if (constant.is_integer()) return product(std::move(factors));
    return fraction(product(std::move(factors)), number(Rational(constant.denominator())));
}

Formula GroundFormulas::argument(const proofs::NodeArgument& argument) {
    const proofs::NodeId u = argument.coordinates.front();
    const proofs::Node& mass = block_.nodes[argument.mass];
    if (has_values()) return argument_formula(Argument(evaluate_(u), evaluate_(argument.mass)));
    if (mass.kind != NodeKind::constant) return tuple({(*this)(u), (*this)(argument.mass)});
    if (mass.value == Rational(1)) return (*this)(u);
    if (!mass.value.is_zero()) return tuple({(*this)(u), number(mass.value)});
    const proofs::Node& length = block_.nodes[u];
    const bool unit = length.kind == NodeKind::constant && length.value == Rational(1);
    return unit ? symbol("delta") : product({(*this)(u), symbol("delta")});
}

Formula GroundFormulas::application(const proofs::Application& application) {
    const std::string& name = block_.maps[application.map].name;
    using Form = proofs::Application::Form;
    if (application.form == Form::derivative && application.orders.front() > 0)
        return derivative_of(name, application.orders.front(), argument(application.places.front()));
    if (application.form == Form::derivative) return call(name, {argument(application.places.front())});
    std::vector<Formula> arguments;
    arguments.reserve(application.arguments.front().size());
    for (const proofs::NodeArgument& one : application.arguments.front()) arguments.push_back(argument(one));
    if (application.form == Form::blossom) return blossom_of(name, std::move(arguments));
    // The homogeneous form at a pair has two arguments.
    if (arguments.front().kind == FormulaKind::tuple) return call(name, std::move(arguments.front().parts));
    return call(name, std::move(arguments));
}

Formula GroundFormulas::expanded(const proofs::Fraction& fraction_of,
                                 const std::vector<SparsePolynomial>& factors) const {
    std::vector<Formula> symbols;
    symbols.reserve(block_.symbols.size());
    for (std::size_t i = 0; i < block_.symbols.size(); ++i) symbols.push_back(symbol_formula(i));
    const auto written = [&](const SparsePolynomial& polynomial) {
        return sparse_formula(polynomial, symbols, symbols.size());
    };
    if (fraction_of.denominator.empty()) return written(fraction_of.numerator);
    std::vector<Formula> divisors;
    divisors.reserve(fraction_of.denominator.size());
    for (const auto& [factor, exponent] : fraction_of.denominator) {
        divisors.push_back(power(written(factors[factor]), number(exponent)));
    }
    return fraction(written(fraction_of.numerator), product(std::move(divisors)));
}

}  // namespace blossom::worked
