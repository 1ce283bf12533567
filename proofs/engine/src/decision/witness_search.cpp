#include "witness_search.hpp"

#include <algorithm>
#include <iterator>

namespace blossom::proofs {

namespace {

/// 0, 1, -1, 2, -2, ...
Rational small_integer(std::size_t number) {
    const auto half = static_cast<long long>((number + 1) / 2);
    return number % 2 == 1 ? half : -half;
}

/// The symbols without a step, in the order in which they receive values.
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

}  // namespace

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

WitnessSearch::WitnessSearch(const GroundBlock& block, std::span<const Substitution> steps,
                             std::vector<SparsePolynomial> nonzero)
    : block_(block), steps_(steps), nonzero_(std::move(nonzero)), values_(block.symbols.size()) {
    relations_.reserve(steps.size());
    for (const Substitution& step : steps) relations_.push_back(step.relation);
}

bool WitnessSearch::choose(std::size_t attempt) {
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

bool WitnessSearch::is_witness() const {
    if (algebraic_.empty()) return true;
    std::size_t dimension = 1;
    for (const Substitution& step : steps_) {
        if (is_root(step.symbol)) dimension *= step.degree;
    }
    SparsePolynomial product = 1;
    for (const SparsePolynomial& factor : nonzero_) product *= factor;
    std::optional<SparsePolynomial> power = remainder(std::move(product));
    for (std::size_t exponent = 1; power && exponent < dimension; exponent *= 2)
        power = remainder(*power * *power);
    return !power || !power->is_zero();
}

void WitnessSearch::put(std::size_t symbol, const Rational& value) {
    values_[symbol] = value;
    for (SparsePolynomial& polynomial : nonzero_) polynomial = specialised(polynomial, symbol, value);
    for (SparsePolynomial& relation : relations_) relation = specialised(relation, symbol, value);
}

bool WitnessSearch::is_possible(std::size_t symbol, const Rational& value) const {
    return std::ranges::none_of(nonzero_, [&](const SparsePolynomial& polynomial) {
        return specialised(polynomial, symbol, value).is_zero();
    });
}

void WitnessSearch::give_value(std::size_t symbol, std::size_t first) {
    static const Rational triples[] = {Rational(3, 5), Rational(5, 13), Rational(1, 2), Rational(2)};
    if (first > 0 && is_possible(symbol, triples[(first - 1) % std::size(triples)])) {
        put(symbol, triples[(first - 1) % std::size(triples)]);
        return;
    }
    std::size_t number = 0;
    while (!is_possible(symbol, small_integer(number))) ++number;
    put(symbol, small_integer(number));
}

bool WitnessSearch::solve(std::size_t number) {
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

std::optional<SparsePolynomial> WitnessSearch::remainder(SparsePolynomial polynomial) const {
    constexpr std::size_t most_rounds = 1000;
    for (std::size_t round = 0; round < most_rounds; ++round) {
        std::size_t i = 0;
        while (i < steps_.size() &&
               (!is_root(steps_[i].symbol) || polynomial.degree_in(steps_[i].symbol) < steps_[i].degree))
            ++i;
        if (i == steps_.size()) return polynomial;
        const std::size_t symbol = steps_[i].symbol;
        const std::size_t degree = steps_[i].degree;
        const SparsePolynomial leading = coefficients_in(relations_[i], symbol)[degree];
        if (leading.is_zero() || leading.total_degree() > 0) return std::nullopt;
        const std::size_t present = polynomial.degree_in(symbol);
        const SparsePolynomial factor = coefficients_in(polynomial, symbol)[present] *
                                        SparsePolynomial(Rational(1) / leading.coefficient(0));
        polynomial -= factor * pow(SparsePolynomial::variable(symbol), present - degree) * relations_[i];
    }
    return std::nullopt;
}

bool WitnessSearch::is_root(std::size_t symbol) const {
    return std::ranges::find(algebraic_, symbol) != algebraic_.end();
}

bool WitnessSearch::leave(std::size_t symbol) {
    algebraic_.push_back(symbol);
    return false;
}

}  // namespace blossom::proofs
