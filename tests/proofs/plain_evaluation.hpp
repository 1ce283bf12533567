#pragma once

#include <blossom/proofs/ground.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <map>
#include <vector>

/// Values of ground expressions by independent definitions: a blossom is the alternating sum of the
/// homogeneous form over the sums of its arguments (Fernandez-Jambrina, equation (18)).

namespace blossom::testing {

class PlainEvaluation {
public:
    PlainEvaluation(const proofs::GroundBlock& block, std::vector<Rational> symbols)
        : block_(block), symbols_(std::move(symbols)) {}

    Rational operator()(proofs::NodeId id) {
        const auto known = known_.find(id);
        if (known != known_.end()) return known->second;
        return known_[id] = value(block_.nodes[id]);
    }

private:
    using Argument = std::vector<Rational>;  ///< coordinates, followed by the mass

    Rational value(const proofs::Node& node) {
        using proofs::NodeKind;
        Rational result;
        switch (node.kind) {
            case NodeKind::constant:
                return node.value;
            case NodeKind::symbol:
                return symbols_[node.index];
            case NodeKind::sum:
                for (const auto operand : node.operands) result += (*this)(operand);
                return result;
            case NodeKind::product:
                result = 1;
                for (const auto operand : node.operands) result *= (*this)(operand);
                return result;
            case NodeKind::quotient:
                return (*this)(node.operands[0]) / (*this)(node.operands[1]);
            case NodeKind::power:
                return pow((*this)(node.operands[0]), node.index);
            case NodeKind::application:
                return application(block_.applications[node.index]);
            case NodeKind::derivative:
                throw Error(ErrorCode::wrong_kind, "the derivative of an expression has no plain value");
        }
        return result;
    }

    Argument argument(const proofs::NodeArgument& given) {
        Argument result;
        for (const auto coordinate : given.coordinates) result.push_back((*this)(coordinate));
        result.push_back((*this)(given.mass));
        return result;
    }

    Rational application(const proofs::Application& application) {
        using Form = proofs::Application::Form;
        const proofs::GroundMap& map = block_.maps[application.map];
        std::vector<Argument> chosen;
        const bool by_powers = std::ranges::all_of(
            map.directions, [](const auto& direction) { return direction.dimension == 1; });
        if (application.form == Form::derivative && by_powers && map.barycentric.empty()) {
            for (const auto& place : application.places) chosen.push_back(argument(place));
            return form(map, chosen, application.orders);
        }
        std::vector<std::vector<Argument>> arguments;
        for (const auto& list : application.arguments) {
            arguments.emplace_back();
            for (const auto& given : list) arguments.back().push_back(argument(given));
        }
        if (application.form != Form::value) {
            chosen.resize(arguments.size());
            return application.scale * alternating(map, arguments, 0, chosen);
        }
        for (const auto& list : arguments) chosen.push_back(list.front());
        return form(map, chosen, std::vector<std::size_t>(arguments.size(), 0));
    }

    Rational alternating(const proofs::GroundMap& map, const std::vector<std::vector<Argument>>& arguments,
                         std::size_t direction, std::vector<Argument>& chosen) {
        if (direction == arguments.size()) return form(map, chosen, std::vector<std::size_t>(direction, 0));
        const auto& list = arguments[direction];
        Rational total;
        for (std::size_t subset = 0; subset < std::size_t{1} << list.size(); ++subset) {
            Argument sum(map.directions[direction].dimension + 1);
            bool negative = false;
            for (std::size_t i = 0; i < list.size(); ++i) {
                if ((subset >> i) % 2 == 0) {
                    negative = !negative;
                } else {
                    for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += list[i][j];
                }
            }
            chosen[direction] = sum;
            const Rational term = alternating(map, arguments, direction + 1, chosen);
            total += negative ? -term : term;
        }
        return total / Rational(factorial(list.size()));
    }

    /// The homogeneous form, or its derivative of the given orders.
    Rational form(const proofs::GroundMap& map, const std::vector<Argument>& point,
                  const std::vector<std::size_t>& orders) {
        Rational total;
        const auto exponents = proofs::monomials(map.directions);
        for (std::size_t k = 0; k < exponents.size(); ++k) {
            Rational term = (*this)(map.coefficients[k]);
            std::size_t place = 0;
            for (std::size_t i = 0; i < map.directions.size(); ++i) {
                std::size_t used = 0;
                for (std::size_t j = 0; j < map.directions[i].dimension; ++j, ++place) {
                    const std::size_t power = exponents[k][place];
                    used += power;
                    term *= Rational(falling_factorial(power, orders[i]));
                    if (power >= orders[i]) term *= pow(point[i][j], power - orders[i]);
                }
                term *= pow(point[i].back(), map.directions[i].degree - used);
            }
            total += term;
        }
        return total;
    }

    const proofs::GroundBlock& block_;
    std::vector<Rational> symbols_;
    std::map<proofs::NodeId, Rational> known_;
};

}  // namespace blossom::testing
