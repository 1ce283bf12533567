#include "symbolic.hpp"

#include <blossom/rational/combinatorics.hpp>

#include <bit>
#include <utility>

namespace blossom::testing {

namespace {

using Pairs = std::vector<HomogeneousPair<Symbol>>;

Pairs pairs(const SymbolicArguments& arguments) { return {arguments.begin(), arguments.end()}; }

Symbol quotient(const Quotients<Symbol>& value) {
    return value.numerators.front() * Symbol(Rational(1, value.denominator));
}

}  // namespace

Symbols Variables::next(std::size_t n) {
    Symbols symbols;
    while (symbols.size() < n) symbols.push_back(next());
    return symbols;
}

SymbolicArguments points(const Symbols& symbols) { return {symbols.begin(), symbols.end()}; }

SymbolicArguments generic_pairs(Variables& variables, std::size_t n) {
    SymbolicArguments pairs;
    for (std::size_t i = 0; i < n; ++i) {
        const Symbol u = variables.next();
        pairs.emplace_back(u, variables.next());
    }
    return pairs;
}

SymbolicArguments copies(std::size_t k, const SymbolicArgument& argument) {
    return SymbolicArguments(k, argument);
}

SymbolicArguments joined(std::initializer_list<SymbolicArguments> lists) {
    SymbolicArguments all;
    for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
    return all;
}

Symbol by_symmetric_functions(const Symbols& coefficients, const SymbolicArguments& arguments) {
    const std::vector<std::span<const Symbol>> rows{coefficients};
    return quotient(constructions::by_symmetric_functions<Symbol>(rows, pairs(arguments)));
}

Symbol by_polarization(const Symbols& coefficients, const SymbolicArguments& arguments) {
    const auto form = [&](const HomogeneousPair<Symbol>& pair) {
        return Symbols{form_value(coefficients, pair.u, pair.mass)};
    };
    return quotient(constructions::by_polarization<Symbol>(form, pairs(arguments)));
}

Symbol by_casteljau(const Symbols& control_points, const Integer& a, const Integer& b, const Integer& q,
                    const SymbolicArguments& arguments) {
    const std::vector<std::span<const Symbol>> rows{control_points};
    return quotient(constructions::by_casteljau<Symbol>(rows, a, b, q, pairs(arguments)));
}

Symbol polynomial_value(const Symbols& coefficients, const Symbol& t) {
    return form_value(coefficients, t, 1);
}

Symbol form_value(const Symbols& coefficients, const Symbol& u, const Symbol& v) {
    const std::size_t n = coefficients.size() - 1;
    Symbols terms;
    for (std::size_t k = 0; k <= n; ++k) terms.push_back(coefficients[k] * (pow(u, k) * pow(v, n - k)));
    return sum(terms);
}

Symbol bernstein_value(const Symbols& control_points, const Symbol& x, const Symbol& y) {
    Symbols coefficients;
    const std::vector<Integer> binomials = binomial_row(control_points.size() - 1);
    for (std::size_t k = 0; k < control_points.size(); ++k)
        coefficients.push_back(scaled(binomials[k], control_points[k]));
    return form_value(coefficients, x, y);
}

Symbol subset_average(const Symbols& symbols, std::size_t k) {
    Symbols products;
    for (std::size_t subset = 0; subset < std::size_t{1} << symbols.size(); ++subset) {
        if (static_cast<std::size_t>(std::popcount(subset)) != k) continue;
        Symbol term = 1;
        for (std::size_t i = 0; i < symbols.size(); ++i) {
            if ((subset >> i & 1) != 0) term *= symbols[i];
        }
        products.push_back(std::move(term));
    }
    return sum(products) * Symbol(Rational(1, products.size()));
}

Symbol scaled(const Integer& factor, const Symbol& symbol) { return symbol * Symbol(factor); }

}  // namespace blossom::testing
