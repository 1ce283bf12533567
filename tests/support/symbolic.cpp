#include "symbolic.hpp"

#include <blossom/rational/combinatorics.hpp>

#include <bit>
#include <map>
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

SymbolicArguments without(SymbolicArguments arguments, std::size_t index) {
    arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(index));
    return arguments;
}

SymbolicArguments replaced(SymbolicArguments arguments, std::size_t index, const SymbolicArgument& argument) {
    arguments[index] = argument;
    return arguments;
}

Symbol SymbolicBlossom::operator()(const SymbolicArguments& arguments) const {
    return source_ == Source::coefficients ? by_symmetric_functions(numbers_, arguments)
                                           : by_casteljau(numbers_, 0, 1, 1, arguments);
}

Symbol GenericPolynomial::operator()(const Symbol& t) const { return polynomial_value(c, t); }

Symbol GenericBezier::operator()(const Symbol& u) const { return bernstein_value(v, u, Symbol(1) - u); }

std::size_t rank_of_conditions(const Symbols& identities, std::size_t unknowns) {
    std::map<std::pair<std::size_t, std::vector<std::size_t>>, std::vector<Rational>> conditions;
    for (std::size_t i = 0; i < identities.size(); ++i) {
        for (std::size_t term = 0; term < identities[i].size(); ++term) {
            std::size_t unknown = 0;
            std::vector<std::size_t> others;
            for (std::size_t k = 0; k < identities[i].variables(); ++k) {
                const std::size_t exponent = identities[i].exponent(term, k);
                if (k >= unknowns) {
                    others.push_back(exponent);
                } else if (exponent == 1) {
                    unknown = k;
                }
            }
            auto& row = conditions[{i, others}];
            row.resize(unknowns);
            row[unknown] += identities[i].coefficient(term);
        }
    }
    std::vector<std::vector<Rational>> rows;
    for (auto& [key, row] : conditions) rows.push_back(std::move(row));

    std::size_t rank = 0;
    for (std::size_t column = 0; column < unknowns; ++column) {
        std::size_t pivot = rank;
        while (pivot < rows.size() && rows[pivot][column].is_zero()) ++pivot;
        if (pivot == rows.size()) continue;
        std::swap(rows[rank], rows[pivot]);
        for (std::size_t i = rank + 1; i < rows.size(); ++i) {
            const Rational factor = rows[i][column] / rows[rank][column];
            for (std::size_t k = column; k < unknowns; ++k) rows[i][k] -= factor * rows[rank][k];
        }
        ++rank;
    }
    return rank;
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

Symbols derivative_coefficients(Symbols coefficients, std::size_t order) {
    for (; order > 0; --order) {
        for (std::size_t k = 1; k < coefficients.size(); ++k)
            coefficients[k - 1] = scaled(k, coefficients[k]);
        coefficients.pop_back();
        if (coefficients.empty()) return {0};
    }
    return coefficients;
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

Symbol product(const Symbols& symbols) {
    Symbol result = 1;
    for (const Symbol& symbol : symbols) result *= symbol;
    return result;
}

Symbol scaled(const Integer& factor, const Symbol& symbol) { return symbol * Symbol(factor); }

}  // namespace blossom::testing
