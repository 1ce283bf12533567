#include "witness.hpp"

#include <blossom/core/polynomial_text.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <ranges>
#include <set>

#include <blossom/proofs/evaluation.hpp>

namespace blossom::proofs {

namespace {

SparsePolynomial specialised(const SparsePolynomial& polynomial, std::size_t variable,
                             const Rational& value) {
    if (polynomial.degree_in(variable) == 0) return polynomial;
    const auto powers = coefficients_in(polynomial, variable);
    if (value.is_zero()) return powers.front();
    std::vector<SparsePolynomial> summands;
    summands.reserve(powers.size());
    for (std::size_t k = 0; k < powers.size(); ++k) {
        summands.push_back(powers[k] * SparsePolynomial(pow(value, k)));
    }
    return sum(summands);
}

/// 0, 1, -1, 2, -2, ...
Rational small_integer(std::size_t number) {
    const auto half = static_cast<long long>((number + 1) / 2);
    return number % 2 == 1 ? half : -half;
}

/// The symbols without a step, in the order in which they get their values.
std::vector<std::size_t> order_of_symbols(const GroundBlock& block, std::span<const Substitution> steps) {
    std::vector<std::size_t> order;
    for (std::size_t i = block.symbols.size(); i-- > 0;) {
        if (block.symbols[i].is_map_value()) order.push_back(i);
    }
    for (std::size_t i = 0; i < block.symbols.size(); ++i) {
        if (!block.symbols[i].is_map_value()) order.push_back(i);
    }
    for (const Substitution& step : steps) std::erase(order, step.symbol);
    return order;
}

/// Chooses values for the symbols of one branch.
class WitnessSearch {
public:
    WitnessSearch(const GroundBlock& block, std::span<const Substitution> steps,
                  std::vector<SparsePolynomial> nonzero)
        : block_(block), steps_(steps), nonzero_(std::move(nonzero)), values_(block.symbols.size()) {
        for (const Substitution& step : steps) relations_.push_back(step.relation);
    }

    /// With `attempt` the values of variables on which roots depend begin further on in the list, so that
    /// roots may become rational. False if one that has a root has no rational one.
    bool choose(std::size_t attempt) {
        const auto touches_root = [&](std::size_t symbol) {
            return std::ranges::any_of(steps_, [&](const Substitution& step) {
                return step.degree > 1 && step.relation.degree_in(symbol) > 0;
            });
        };
        for (const std::size_t symbol : order_of_symbols(block_, steps_))
            give_value(symbol, touches_root(symbol) ? attempt : 0);
        bool rational = true;
        for (std::size_t i = steps_.size(); i-- > 0;) rational = solve(i) && rational;
        return rational;
    }

    /// Whether some root leaves everything different from zero that must be, where one variable has no
    /// rational value: the product of all has no power that the relation divides.
    bool is_witness() const {
        if (algebraic_.size() != 1) return true;
        const std::size_t symbol = algebraic_.front();
        const auto step = std::ranges::find(steps_, symbol, &Substitution::symbol);
        const SparsePolynomial& relation = relations_[static_cast<std::size_t>(step - steps_.begin())];
        const std::size_t degree = relation.degree_in(symbol);
        SparsePolynomial product = 1;
        for (const SparsePolynomial& factor : nonzero_) product *= factor;
        SparsePolynomial power = 1;
        for (std::size_t k = 0; k < degree; ++k) power = remainder(power * product, relation, symbol);
        return !power.is_zero();
    }

    const std::vector<Rational>& values() const { return values_; }
    const std::vector<std::size_t>& algebraic() const { return algebraic_; }
    const std::vector<SparsePolynomial>& relations() const { return relations_; }

private:
    void put(std::size_t symbol, const Rational& value) {
        values_[symbol] = value;
        for (SparsePolynomial& polynomial : nonzero_) polynomial = specialised(polynomial, symbol, value);
        for (SparsePolynomial& relation : relations_) relation = specialised(relation, symbol, value);
    }

    bool is_possible(std::size_t symbol, const Rational& value) const {
        return std::ranges::none_of(nonzero_, [&](const SparsePolynomial& polynomial) {
            return specialised(polynomial, symbol, value).is_zero();
        });
    }

    /// Each polynomial rules out no more values than it has degree.
    void give_value(std::size_t symbol, std::size_t first) {
        static const Rational triples[] = {Rational(3, 5), Rational(5, 13), Rational(1, 2), Rational(2)};
        if (first > 0 && is_possible(symbol, triples[(first - 1) % std::size(triples)])) {
            put(symbol, triples[(first - 1) % std::size(triples)]);
            return;
        }
        std::size_t number = 0;
        while (!is_possible(symbol, small_integer(number))) ++number;
        put(symbol, small_integer(number));
    }

    /// The value of the symbol of a step, where all others of its relation have one.
    bool solve(std::size_t number) {
        const std::size_t symbol = steps_[number].symbol;
        if (relations_[number].degree_in(symbol) == 0) return true;
        const auto powers = coefficients_in(relations_[number], symbol);
        for (const SparsePolynomial& power : powers) {
            if (power.total_degree() > 0) return leave(symbol);
        }
        std::vector<Rational> coefficients;
        coefficients.reserve(powers.size());
        for (const SparsePolynomial& power : powers)
            coefficients.push_back(power.is_zero() ? Rational(0) : power.coefficient(0));
        if (coefficients.size() == 2) {
            put(symbol, -coefficients[0] / coefficients[1]);
            return true;
        }
        constexpr long long greatest = 30;
        for (long long denominator = 1; denominator <= greatest; ++denominator) {
            for (long long numerator = -greatest; numerator <= greatest; ++numerator) {
                const Rational root{Integer(numerator), Integer(denominator)};
                Rational value;
                for (std::size_t k = coefficients.size(); k-- > 0;) value = value * root + coefficients[k];
                if (!value.is_zero() || !is_possible(symbol, root)) continue;
                put(symbol, root);
                return true;
            }
        }
        return leave(symbol);
    }

    static SparsePolynomial remainder(SparsePolynomial polynomial, const SparsePolynomial& relation,
                                      std::size_t symbol) {
        const std::vector<SparsePolynomial> divisor = coefficients_in(relation, symbol);
        const SparsePolynomial x = SparsePolynomial::variable(symbol);
        while (!polynomial.is_zero() && polynomial.degree_in(symbol) + 1 >= divisor.size()) {
            const std::size_t degree = polynomial.degree_in(symbol);
            const SparsePolynomial factor = coefficients_in(polynomial, symbol)[degree] *
                                            SparsePolynomial(Rational(1) / divisor.back().coefficient(0));
            polynomial -= factor * pow(x, degree + 1 - divisor.size()) * relation;
        }
        return polynomial;
    }

    bool leave(std::size_t symbol) {
        algebraic_.push_back(symbol);
        return false;
    }

    const GroundBlock& block_;
    std::span<const Substitution> steps_;
    std::vector<SparsePolynomial> nonzero_;
    std::vector<SparsePolynomial> relations_;
    std::vector<Rational> values_;
    std::vector<std::size_t> algebraic_;
};

WitnessMap written_out(const GroundMap& map, Evaluator& evaluate) {
    std::vector<std::string> names;
    std::size_t variables = 0;
    for (const Direction& direction : map.directions) variables += direction.dimension;
    if (variables == 1) {
        names = {"t"};
    } else if (map.directions.size() == 2 && variables == 2) {
        names = {"u", "v"};
    } else {
        names = numbered_names("x", variables);
    }
    const auto exponents = monomials(map.directions);
    std::vector<SparsePolynomial> terms;
    terms.reserve(exponents.size());
    for (std::size_t i = 0; i < exponents.size(); ++i) {
        terms.push_back(SparsePolynomial::term(evaluate(map.coefficients[i]), exponents[i]));
    }
    return {map.name, to_text(sum(terms), names), map.directions};
}

struct WrittenArgument {
    std::string readable;
    std::string option;  ///< as --at takes it
};

WrittenArgument written_out(const NodeArgument& argument, Evaluator& evaluate) {
    const Rational mass = evaluate(argument.mass);
    std::string coordinates;
    for (const NodeId coordinate : argument.coordinates) {
        coordinates += (coordinates.empty() ? "" : ", ") + to_string(evaluate(coordinate));
    }
    if (argument.coordinates.size() > 1) {
        if (mass == Rational(1)) return {"(" + coordinates + ")", ""};
        return {"<(" + coordinates + "), " + to_string(mass) + ">", ""};
    }
    if (mass == Rational(1)) return {coordinates, coordinates};
    if (mass.is_zero()) {
        if (coordinates == "1") return {"delta", "delta"};
        return {"<" + coordinates + ", 0>", "vector:" + coordinates};
    }
    return {"<" + coordinates + ", " + to_string(mass) + ">", "pair:" + coordinates + ":" + to_string(mass)};
}

/// The value of one application, and the command that computes it, for maps of one variable.
WitnessValue written_out(const GroundBlock& block, NodeId id, const std::vector<WitnessMap>& maps,
                         Evaluator& evaluate) {
    const Application& application = block.applications[block.nodes[id].index];
    const WitnessMap& map = *std::ranges::find(maps, block.maps[application.map].name, &WitnessMap::name);
    std::string readable;
    std::string options;
    bool has_command = map.directions.size() == 1 && map.directions[0].dimension == 1;
    const bool derivative = application.form == Application::Form::derivative;
    std::vector<std::vector<NodeArgument>> shown = application.arguments;
    if (derivative) shown = {application.places};
    for (const auto& list : shown) {
        if (!readable.empty()) readable += "; ";
        for (std::size_t i = 0; i < list.size(); ++i) {
            const auto [text, option] = written_out(list[i], evaluate);
            readable += (i == 0 ? "" : ", ") + text;
            options += (i == 0 ? "" : ",") + option;
        }
    }
    std::string order;
    std::string name = map.name;
    for (const std::size_t k : application.orders) order += (order.empty() ? "" : ", ") + std::to_string(k);
    if (derivative) name = "D(" + map.name + ", " + order + ")";
    const bool polar = application.form == Application::Form::blossom;
    WitnessValue result{polar ? name + "[" + readable + "]" : name + "(" + readable + ")", ""};
    result.text += " = " + to_string(evaluate(id));
    const bool plain = polar || options.find(':') == std::string::npos;
    if (has_command && plain && !options.empty()) {
        result.command = std::string("blossom ") +
                         (polar        ? "blossom"
                          : derivative ? "derivative"
                                       : "evaluate") +
                         " \"" + map.text + "\" --degree " + std::to_string(map.directions[0].degree) +
                         (derivative ? " --order " + order : "") + " --at " + options;
    }
    return result;
}

/// Everything that the claim, the hypotheses and the assumptions are made of.
std::set<NodeId> nodes_of_case(const GroundBlock& block, const Relation& relation) {
    std::vector<NodeId> roots{relation.left, relation.right};
    for (const auto* list : {&block.hypotheses, &block.assumptions}) {
        for (const Relation& other : *list) roots.insert(roots.end(), {other.left, other.right});
    }
    return nodes_below(block, std::move(roots));
}

/// The numerator of a side over its denominator, with numbers for all symbols that have one.
std::string side_text(Expander& expander, NodeId side, const WitnessSearch& choice,
                      const std::vector<std::string>& names) {
    const Fraction fraction = expander(side);
    const auto with_values = [&](SparsePolynomial polynomial) {
        for (std::size_t i = 0; i < choice.values().size(); ++i) {
            const bool open = std::ranges::find(choice.algebraic(), i) != choice.algebraic().end();
            if (!open) polynomial = specialised(polynomial, i, choice.values()[i]);
        }
        return "(" + to_text(polynomial, names) + ")";
    };
    std::string text = with_values(fraction.numerator);
    for (const auto& [factor, exponent] : fraction.denominator) {
        text += "/" + with_values(expander.field().factors()[factor]);
        if (exponent > 1) text += "^" + std::to_string(exponent);
    }
    return text;
}

}  // namespace

std::vector<std::pair<std::string, Rational>> some_point(const GroundBlock& block,
                                                         std::span<const Substitution> steps,
                                                         const std::vector<SparsePolynomial>& nonzero) {
    WitnessSearch search(block, steps, nonzero);
    std::vector<std::pair<std::string, Rational>> point;
    if (!search.choose(0)) return point;
    for (std::size_t i = 0; i < block.symbols.size(); ++i) {
        if (!block.symbols[i].is_bound) point.emplace_back(block.symbols[i].name, search.values()[i]);
    }
    return point;
}

Witness find_counterexample(const GroundBlock& block, const Relation& relation, Expander& expander,
                            std::span<const Substitution> steps, const SparsePolynomial& difference,
                            const std::vector<SparsePolynomial>& nonzero) {
    std::vector<SparsePolynomial> required = nonzero;
    required.insert(required.begin(), difference);
    constexpr std::size_t most_attempts = 5;
    std::optional<WitnessSearch> choice;
    for (std::size_t attempt = 0; attempt < most_attempts; ++attempt) {
        WitnessSearch next(block, steps, required);
        const bool rational = next.choose(attempt);
        if (!rational && !next.is_witness()) continue;
        if (rational || !choice) choice.emplace(std::move(next));
        if (rational) break;
    }
    if (!choice) {
        throw Error(
            ErrorCode::limit_exceeded,
            "the sides differ, but no small values of the variables show it where the hypotheses have roots",
            "", relation.offset);
    }
    std::vector<std::string> names;
    names.reserve(block.symbols.size());
    for (const Symbol& symbol : block.symbols) names.push_back(symbol.name);
    Witness witness;
    Counterexample& result = witness.counterexample;
    result.parameters = block.parameters;
    result.parameters.insert(result.parameters.end(), relation.parameters.begin(), relation.parameters.end());
    const auto is_algebraic = [&](std::size_t i) {
        return std::ranges::find(choice->algebraic(), i) != choice->algebraic().end();
    };
    const std::set<NodeId> nodes = nodes_of_case(block, relation);
    std::set<std::size_t> maps;
    std::set<std::size_t> symbols;
    for (const NodeId id : nodes) {
        const Node& node = block.nodes[id];
        if (node.kind == NodeKind::application) maps.insert(block.applications[node.index].map);
        if (node.kind == NodeKind::symbol && !block.symbols[node.index].is_coefficient &&
            !block.symbols[node.index].is_bound) {
            symbols.insert(node.index);
        }
    }
    for (std::size_t i = 0; i < block.symbols.size(); ++i) {
        if (is_algebraic(i)) {
            witness.algebraic.push_back(names[i]);
        } else if (!block.symbols[i].is_bound) {
            witness.values.emplace_back(names[i], choice->values()[i]);
        }
    }
    for (const std::size_t symbol : symbols) {
        if (!is_algebraic(symbol)) result.variables.emplace_back(names[symbol], choice->values()[symbol]);
    }
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (is_algebraic(steps[i].symbol))
            result.roots.push_back(to_text(choice->relations()[i], names) + " == 0");
    }
    if (!choice->algebraic().empty()) {
        for (std::size_t i = 0; i < block.symbols.size(); ++i) {
            if (block.symbols[i].is_coefficient && !is_algebraic(i))
                result.variables.emplace_back(names[i], choice->values()[i]);
        }
        result.left = side_text(expander, relation.left, *choice, names);
        result.right = side_text(expander, relation.right, *choice, names);
        return witness;
    }
    Evaluator evaluate(block, choice->values());
    result.left = to_string(evaluate(relation.left));
    result.right = to_string(evaluate(relation.right));
    if (result.left == result.right) {
        throw Error(ErrorCode::internal, "the counterexample found is none: this is an error of the program",
                    "", relation.offset);
    }
    for (const std::size_t map : maps) {
        if (block.maps[map].barycentric.empty())
            result.maps.push_back(written_out(block.maps[map], evaluate));
    }
    std::set<std::string> listed;
    for (const NodeId id : nodes_below(block, {relation.left, relation.right})) {
        if (block.nodes[id].kind != NodeKind::application) continue;
        const GroundMap& map = block.maps[block.applications[block.nodes[id].index].map];
        if (!map.barycentric.empty()) continue;
        WitnessValue value = written_out(block, id, result.maps, evaluate);
        if (listed.insert(value.text).second) result.values.push_back(std::move(value));
    }
    return witness;
}

}  // namespace blossom::proofs
