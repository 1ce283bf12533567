#include "symbolic_field.hpp"

#include <algorithm>

namespace blossom::proofs::second {

std::optional<std::uint32_t> SymbolicField::known_factor(const PlainPolynomial& factor) const {
    const auto [begin, end] = factor_places_.equal_range(factor.hash());
    for (auto place = begin; place != end; ++place) {
        if (factors_[place->second] == factor) return place->second;
    }
    return std::nullopt;
}

std::uint32_t SymbolicField::factor_number(const PlainPolynomial& factor) {
    if (const auto known = known_factor(factor)) return *known;
    const auto number = static_cast<std::uint32_t>(factors_.size());
    factors_.push_back(factor);
    factor_places_.emplace(factor.hash(), number);
    return number;
}

Rational SymbolicField::split_into_factors(const PlainPolynomial& a, Denominator& powers) {
    PlainPolynomial rest = a.primitive();
    const Rational unit = a.coefficient(0) / rest.coefficient(0);
    if (rest.is_number()) return unit;
    if (const auto known = known_factor(rest)) {
        powers.push_back({*known, 1});
        return unit;
    }
    budget_.spend(factors_.size());
    for (std::size_t k = 0; k < factors_.size() && !rest.is_number(); ++k) {
        const PlainPolynomial factor = factors_[k];
        divide_out(rest, factor, powers);
    }
    for (const std::size_t symbol : rest.symbols()) divide_out(rest, PlainPolynomial::symbol(symbol), powers);
    divide_out_differences(rest, powers);
    if (!rest.is_number()) powers.push_back({factor_number(rest), 1});
    std::ranges::sort(powers, {}, &FactorPower::factor);
    return unit;
}

void SymbolicField::divide_out(PlainPolynomial& rest, const PlainPolynomial& factor, Denominator& powers) {
    std::uint32_t exponent = 0;
    while (auto exact = exact_quotient(rest, factor, budget_)) {
        rest = std::move(*exact);
        ++exponent;
    }
    if (exponent > 0) powers.push_back({factor_number(factor), exponent});
}

void SymbolicField::divide_out_differences(PlainPolynomial& rest, Denominator& powers) {
    // the fewest terms of a product with such a factor, if it has no symbols as factors
    constexpr std::size_t least_terms = 3;
    const std::vector<std::size_t> symbols = rest.symbols();
    for (std::size_t i = 0; i < symbols.size() && rest.size() >= least_terms; ++i) {
        // The first symbol of a difference is in the first term of the product, the other one in the last.
        if (rest.exponent(0, symbols[i]) == 0) continue;
        for (std::size_t j = i + 1; j < symbols.size() && rest.size() >= least_terms; ++j) {
            if (rest.exponent(rest.size() - 1, symbols[j]) == 0) continue;
            budget_.spend(1);
            divide_out(
                rest,
                difference(PlainPolynomial::symbol(symbols[i]), PlainPolynomial::symbol(symbols[j]), budget_),
                powers);
        }
    }
}

std::vector<PlainPolynomial> SymbolicField::divisors() {
    std::vector<PlainPolynomial> result;
    std::size_t number = 0;
    while (number < factors_.size()) {
        const PlainPolynomial factor = factors_[number++];
        const std::vector<std::size_t> symbols = factor.symbols();
        std::vector<std::size_t> hidden;
        std::ranges::set_intersection(symbols, hidden_symbols_, std::back_inserter(hidden));
        if (hidden.empty()) {
            result.push_back(factor);
            continue;
        }
        const std::vector<PlainPolynomial> coefficients = coefficients_by_monomials(factor, hidden, budget_);
        // Splitting may append factors, which this loop then reaches.
        Denominator powers;
        if (coefficients.size() == 1) split_into_factors(coefficients.front(), powers);
    }
    return result;
}

std::pair<SymbolicField::Denominator, SymbolicField::Denominator> SymbolicField::separated(
    const Denominator& denominator, std::size_t symbol) const {
    std::pair<Denominator, Denominator> result;
    for (const FactorPower& power : denominator) {
        (factors_[power.factor].degree(symbol) == 0 ? result.first : result.second).push_back(power);
    }
    return result;
}

SymbolicField::Element SymbolicField::derived(const Element& a, std::size_t symbol) {
    Sum storage;
    const Sum& of = settled(a, storage);
    PlainPolynomial above = derivative_by(numerator_of(of), symbol, budget_);
    auto [free, factors] = separated(of.denominator, symbol);
    // (N / prod f_i^e_i)' = (N' prod f_i - N sum e_i f_i' prod_(j /= i) f_j) / prod f_i^(e_i + 1)
    PlainPolynomial all(1);
    PlainPolynomial logarithmic;
    for (FactorPower& power : factors) {
        const PlainPolynomial factor = factors_[power.factor];
        const PlainPolynomial slope = scaled(derivative_by(factor, symbol, budget_), power.exponent, budget_);
        logarithmic = second::sum(second::product(logarithmic, factor, budget_),
                                  second::product(all, slope, budget_), budget_);
        all = second::product(all, factor, budget_);
        ++power.exponent;
    }
    above = second::difference(second::product(above, all, budget_),
                               second::product(numerator_of(of), logarithmic, budget_), budget_);
    Denominator denominator = std::move(free);
    denominator.insert(denominator.end(), factors.begin(), factors.end());
    std::ranges::sort(denominator, {}, &FactorPower::factor);
    cancel(above, denominator);
    return fraction(std::move(above), std::move(denominator));
}

SymbolicField::Element SymbolicField::replaced(const Element& a, std::size_t symbol, const Element& by) {
    Sum storage;
    const Sum& of = settled(a, storage);
    auto [free, factors] = separated(of.denominator, symbol);
    Element result;
    const std::vector<PlainPolynomial> coefficients = coefficients_by(numerator_of(of), symbol, budget_);
    for (std::size_t k = coefficients.size(); k-- > 0;) {
        result = sum(product(result, by), fraction(coefficients[k], free));
    }
    for (const FactorPower& power : factors) {
        const Element factor = replaced(fraction(factors_[power.factor], {}), symbol, by);
        result = quotient(result, this->power(factor, power.exponent));
    }
    return result;
}

SymbolicField::Element SymbolicField::derivative(const std::function<Element(const Element&)>& f,
                                                 const Element& at, std::size_t order) {
    const std::size_t first_factor = factors_.size();
    const std::size_t symbol = new_symbol("", true);
    Element result = f(fraction(PlainPolynomial::symbol(symbol), {}));
    for (std::size_t k = 0; k < order && !is_zero(result); ++k) result = derived(result, symbol);
    // Divisors of f must not vanish at this value, even if the derivative does not contain them.
    for (std::size_t k = first_factor; k < factors_.size(); ++k) {
        const PlainPolynomial factor = factors_[k];
        if (factor.degree(symbol) > 0) require_nonzero(replaced(fraction(factor, {}), symbol, at));
    }
    return replaced(result, symbol, at);
}

std::vector<SymbolicField::Element> SymbolicField::coefficients(
    const std::function<Element(const Element&)>& f, std::size_t degree) {
    const std::size_t symbol = new_symbol("", true);
    const Element value = f(fraction(PlainPolynomial::symbol(symbol), {}));
    Sum storage;
    const Sum& sum = settled(value, storage);
    if (!separated(sum.denominator, symbol).second.empty()) {
        throw Error(ErrorCode::syntax, "what should be a polynomial has a divisor with its variable");
    }
    const std::vector<PlainPolynomial> found = coefficients_by(numerator_of(sum), symbol, budget_);
    if (found.size() > degree + 1) {
        throw Error(ErrorCode::degree_too_low, "a polynomial of degree " + std::to_string(found.size() - 1) +
                                                   " is given the degree " + std::to_string(degree));
    }
    std::vector<Element> result(degree + 1);
    for (std::size_t k = 0; k < found.size(); ++k) {
        PlainPolynomial numerator = found[k];
        Denominator denominator = sum.denominator;
        cancel(numerator, denominator);
        result[k] = fraction(std::move(numerator), std::move(denominator));
    }
    return result;
}

}  // namespace blossom::proofs::second
