#include <blossom/proofs/evaluation.hpp>

#include "polar_form.hpp"

namespace blossom::proofs {

Rational Evaluator::operator()(NodeId id) {
    known_.resize(block_.nodes.size());
    if (known_[id]) return *known_[id];
    const Node& node = block_.nodes[id];
    Rational result;
    switch (node.kind) {
        case NodeKind::constant:
            result = node.value;
            break;
        case NodeKind::symbol:
            result = symbols_[node.index];
            break;
        case NodeKind::sum:
            for (const NodeId operand : node.operands) result += (*this)(operand);
            break;
        case NodeKind::product:
            result = 1;
            for (const NodeId operand : node.operands) result *= (*this)(operand);
            break;
        case NodeKind::quotient:
            result = (*this)(node.operands[0]) / (*this)(node.operands[1]);
            break;
        case NodeKind::power:
            result = pow((*this)(node.operands[0]), node.index);
            break;
        case NodeKind::application:
            result = application(block_.applications[node.index]);
            break;
        case NodeKind::derivative: {
            const Fraction expanded = expand_(id);
            result = expanded.numerator(symbols_);
            for (const auto& [factor, exponent] : expanded.denominator)
                result /= pow(expand_.field().factors()[factor](symbols_), exponent);
        }
    }
    known_[id] = result;
    return result;
}

Rational Evaluator::application(const Application& application) {
    const GroundMap& map = block_.maps[application.map];
    std::vector<std::vector<RingArgument<Rational>>> arguments;
    for (const auto& list : application.arguments) {
        arguments.emplace_back();
        for (const NodeArgument& argument : list) {
            RingArgument<Rational> value{{}, (*this)(argument.mass)};
            for (const NodeId coordinate : argument.coordinates)
                value.coordinates.push_back((*this)(coordinate));
            arguments.back().push_back(std::move(value));
        }
    }
    std::vector<Rational> coefficients;
    coefficients.reserve(map.coefficients.size());
    for (const NodeId coefficient : map.coefficients) coefficients.push_back((*this)(coefficient));
    const bool value = application.form == Application::Form::value;
    Rational scale = application.scale;
    Rational result = contracted(
        map.directions, std::move(coefficients), [&](std::size_t i, std::span<const Rational> row) {
            return value ? form_value<Rational>(map.directions[i], row, arguments[i].front())
                         : polar_form<Rational>(map.directions[i], row, arguments[i]);
        });
    if (value) return result;
    for (const Direction& direction : map.directions) scale /= Rational(factorial(direction.degree));
    return result * scale;
}

}  // namespace blossom::proofs
