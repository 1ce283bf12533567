#include "branch_state.hpp"

#include <algorithm>

namespace blossom::proofs::second {

BranchState::BranchState(const std::vector<PlainPolynomial>& equations,
                         const std::vector<PlainPolynomial>& nonzero, PlainPolynomial difference,
                         Budget& budget)
    : budget_(&budget) {
    for (const PlainPolynomial& factor : nonzero) add_nonzero(factor);
    for (const PlainPolynomial& equation : equations) add_equation(equation);
    difference_ = stripped(std::move(difference));
}

std::string BranchState::take_step(std::size_t symbol, std::size_t degree, const PlainPolynomial& relation) {
    const bool has_power =
        std::ranges::any_of(power_steps_, [&](const PowerStep& step) { return step.symbol == symbol; });
    const bool again = std::ranges::find(solved_, symbol) != solved_.end();
    if (again && (!has_power || degree != 1)) return "the symbol is solved for a second time";
    const PlainPolynomial usable = reduced(relation);
    budget_->spend(equations_.size());
    const bool follows = std::ranges::any_of(equations_, [&](const PlainPolynomial& equation) {
        return is_zero_where(equation, usable, equation.degree(symbol));
    });
    if (!follows) return "the relation is no hypothesis";
    const std::vector<PlainPolynomial> coefficients = coefficients_by(usable, symbol, *budget_);
    if (degree == 0 || coefficients.size() != degree + 1)
        return "the relation has another degree in the symbol";
    const PlainPolynomial& leading = coefficients.back();
    if (degree == 1) {
        if (!is_known_nonzero(leading)) return "the cofactor of the symbol may vanish";
        linear_steps_.push_back({symbol, leading, coefficients.front()});
        solved_.push_back(symbol);
        const LinearStep step = linear_steps_.back();
        reduce_power_steps(step);
        reduce_all(&step);
        return "";
    }
    if (!leading.is_number()) return "the relation is not monic in the symbol";
    power_steps_.push_back({symbol, usable});
    solved_.push_back(symbol);
    reduce_all(nullptr);
    return "";
}

/// Whether the relation vanishes wherever the equation does: one is the other times something that does not
/// vanish, or some power of the relation is a multiple of the equation.
bool BranchState::is_zero_where(const PlainPolynomial& equation, const PlainPolynomial& relation,
                                std::size_t powers) {
    if (equation == relation) return true;
    if (relation.is_zero()) return false;
    const auto cofactor = exact_quotient(equation, relation, *budget_);
    if (cofactor && is_known_nonzero(*cofactor)) return true;
    PlainPolynomial power = relation;
    for (std::size_t k = 0; k < powers; ++k) {
        if (exact_quotient(power, equation, *budget_)) return true;
        power = product(power, relation, *budget_);
    }
    return false;
}

bool BranchState::agrees() {
    if (difference_.is_zero() || power_steps_.empty()) return difference_.is_zero();
    std::size_t powers = 1;
    for (const PowerStep& step : power_steps_) powers *= step.relation.degree(step.symbol);
    PlainPolynomial all = difference_;
    for (const PlainPolynomial& factor : nonzero_) {
        const bool concerned = std::ranges::any_of(
            power_steps_, [&](const PowerStep& step) { return factor.degree(step.symbol) > 0; });
        if (concerned) all = with_low_powers(product(all, factor, *budget_));
    }
    PlainPolynomial power = all;
    for (std::size_t k = 1; k < powers && !power.is_zero(); ++k)
        power = with_low_powers(product(power, all, *budget_));
    return power.is_zero();
}

void BranchState::require_nonzero(const PlainPolynomial& pivot) {
    add_nonzero(reduced(pivot));
    reduce_all(nullptr);
}

void BranchState::require_zero(const PlainPolynomial& pivot) { add_equation(reduced(pivot)); }

std::size_t BranchState::size() const {
    std::size_t result = difference_.size();
    for (const PlainPolynomial& equation : equations_) result += equation.size();
    for (const PlainPolynomial& factor : nonzero_) result += factor.size();
    for (const LinearStep& step : linear_steps_) result += step.cofactor.size() + step.rest.size();
    for (const PowerStep& step : power_steps_) result += step.relation.size();
    return result;
}

void BranchState::add_equation(const PlainPolynomial& equation) {
    PlainPolynomial rest = stripped(equation);
    if (rest.is_zero()) return;
    if (rest.is_number()) {
        impossible_ = true;
    } else {
        equations_.push_back(std::move(rest));
    }
}

void BranchState::add_nonzero(PlainPolynomial factor) {
    if (factor.is_zero()) {
        impossible_ = true;
        return;
    }
    for (const std::size_t symbol : factor.symbols()) {
        const PlainPolynomial divisor = PlainPolynomial::symbol(symbol);
        bool divides = false;
        while (auto exact = exact_quotient(factor, divisor, *budget_)) {
            factor = std::move(*exact);
            divides = true;
        }
        if (divides) add_nonzero_part(divisor);
    }
    const std::vector<std::size_t> symbols = factor.symbols();
    for (std::size_t i = 0; i < symbols.size(); ++i) {
        for (std::size_t j = i + 1; j < symbols.size() && factor.size() > 2; ++j) {
            const PlainPolynomial apart = difference(PlainPolynomial::symbol(symbols[i]),
                                                     PlainPolynomial::symbol(symbols[j]), *budget_);
            auto exact = exact_quotient(factor, apart, *budget_);
            if (!exact) continue;
            while (auto again = exact_quotient(*exact, apart, *budget_)) exact = std::move(again);
            factor = std::move(*exact);
            add_nonzero_part(apart);
        }
    }
    add_nonzero_part(std::move(factor));
}

void BranchState::add_nonzero_part(PlainPolynomial factor) {
    factor = stripped(std::move(factor));
    if (factor.is_number()) return;
    // If a product does not vanish, neither do its factors.
    for (PlainPolynomial& known : nonzero_) {
        while (auto exact = exact_quotient(known, factor, *budget_)) known = std::move(*exact);
    }
    std::erase_if(nonzero_, [](const PlainPolynomial& known) { return known.is_number(); });
    nonzero_.push_back(std::move(factor));
}

PlainPolynomial BranchState::stripped(PlainPolynomial a) {
    budget_->spend(nonzero_.size());
    for (const PlainPolynomial& factor : nonzero_) {
        if (a.is_zero()) break;
        while (auto exact = exact_quotient(a, factor, *budget_)) a = std::move(*exact);
    }
    return a.primitive();
}

bool BranchState::is_known_nonzero(const PlainPolynomial& a) {
    if (a.is_zero()) return false;
    const PlainPolynomial rest = stripped(a);
    return rest.is_number() || std::ranges::any_of(nonzero_, [&](const PlainPolynomial& known) {
               return exact_quotient(known, rest, *budget_).has_value();
           });
}

PlainPolynomial BranchState::replaced(const PlainPolynomial& a, const LinearStep& step) {
    const std::vector<PlainPolynomial> coefficients = coefficients_by(a, step.symbol, *budget_);
    if (coefficients.size() == 1) return a;
    // cofactor^d sum_k a_k (-rest / cofactor)^k by Horner's rule
    const PlainPolynomial opposite = scaled(step.rest, -1, *budget_);
    PlainPolynomial result = coefficients.back();
    PlainPolynomial scale = step.cofactor;
    for (std::size_t k = coefficients.size() - 1; k-- > 0;) {
        result =
            sum(product(result, opposite, *budget_), product(coefficients[k], scale, *budget_), *budget_);
        if (k > 0) scale = product(scale, step.cofactor, *budget_);
    }
    return result;
}

PlainPolynomial BranchState::with_low_powers(const PlainPolynomial& a, const PowerStep& step) {
    std::vector<PlainPolynomial> coefficients = coefficients_by(a, step.symbol, *budget_);
    const std::vector<PlainPolynomial> relation = coefficients_by(step.relation, step.symbol, *budget_);
    const std::size_t degree = relation.size() - 1;
    if (coefficients.size() <= degree) return a;
    const PlainPolynomial& leading = relation.back();
    while (coefficients.size() > degree) {
        PlainPolynomial top = std::move(coefficients.back());
        coefficients.pop_back();
        if (leading.is_number()) {
            top = scaled(top, Rational(1) / leading.number(), *budget_);
        } else {
            for (PlainPolynomial& coefficient : coefficients)
                coefficient = product(coefficient, leading, *budget_);
        }
        for (std::size_t k = 0; k < degree; ++k) {
            PlainPolynomial& coefficient = coefficients[coefficients.size() - degree + k];
            coefficient = difference(coefficient, product(top, relation[k], *budget_), *budget_);
        }
    }
    return value_at(coefficients, PlainPolynomial::symbol(step.symbol), *budget_);
}

PlainPolynomial BranchState::with_low_powers(PlainPolynomial a) {
    // Replacing powers of one symbol may bring back those of another. If this does not end, the remaining
    // polynomial is still correct, but less useful.
    for (std::size_t round = 0; round < 2 * power_steps_.size(); ++round) {
        bool changed = false;
        for (const PowerStep& step : power_steps_) {
            if (a.degree(step.symbol) < step.relation.degree(step.symbol)) continue;
            a = with_low_powers(a, step);
            changed = true;
        }
        if (!changed) break;
    }
    return a;
}

PlainPolynomial BranchState::reduced(PlainPolynomial a) {
    for (const LinearStep& step : linear_steps_) a = stripped(replaced(a, step));
    return stripped(with_low_powers(std::move(a)));
}

void BranchState::reduce_power_steps(const LinearStep& step) {
    std::vector<PowerStep> kept;
    for (PowerStep& power_step : power_steps_) {
        if (power_step.relation.degree(step.symbol) == 0) {
            kept.push_back(std::move(power_step));
            continue;
        }
        PlainPolynomial relation = stripped(replaced(power_step.relation, step));
        const std::vector<PlainPolynomial> coefficients =
            coefficients_by(relation, power_step.symbol, *budget_);
        if (coefficients.size() > 2 && is_known_nonzero(coefficients.back())) {
            kept.push_back({power_step.symbol, std::move(relation)});
        } else {
            add_equation(relation);
        }
    }
    power_steps_ = std::move(kept);
}

void BranchState::reduce_all(const LinearStep* step) {
    const auto next = [&](const PlainPolynomial& a) {
        return with_low_powers(step ? replaced(a, *step) : a);
    };
    const std::vector<PlainPolynomial> nonzero = std::move(nonzero_);
    const std::vector<PlainPolynomial> equations = std::move(equations_);
    nonzero_.clear();
    equations_.clear();
    for (const PlainPolynomial& factor : nonzero) add_nonzero(next(factor));
    for (const PlainPolynomial& equation : equations) add_equation(next(equation));
    difference_ = stripped(next(difference_));
}

}  // namespace blossom::proofs::second
