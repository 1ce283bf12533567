#include "symbols.hpp"

#include <blossom/core/algebra/polynomial.hpp>

#include <algorithm>
#include <array>
#include <numeric>

namespace blossom::worked {

std::vector<Formula> numbered_symbols(const std::string& letter, std::size_t n) {
    std::vector<Formula> symbols;
    for (std::size_t i = 1; i <= n; ++i) symbols.push_back(symbol(letter + std::to_string(i)));
    return symbols;
}

Formula sparse_formula(const SparsePolynomial& polynomial, std::span<const Formula> symbols,
                       std::size_t counted) {
    std::vector<std::size_t> order(polynomial.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t term) {
        std::size_t degree = 0;
        for (std::size_t i = 0; i < counted; ++i) degree += polynomial.exponent(term, i);
        return degree;
    });
    std::vector<Formula> terms;
    for (const std::size_t term : order) {
        std::vector<Formula> factors;
        const Rational coefficient = polynomial.coefficient(term);
        for (std::size_t i = 0; i < symbols.size(); ++i) {
            const std::size_t exponent = polynomial.exponent(term, i);
            if (exponent > 0) factors.push_back(power(symbols[i], number(exponent)));
        }
        if (factors.empty() || coefficient != Rational(1))
            factors.insert(factors.begin(), number(coefficient));
        terms.push_back(product(std::move(factors)));
    }
    return sum(std::move(terms));
}

std::vector<Rational> elementary_values(std::span<const Argument> arguments) {
    Polynomial coefficients = 1;
    for (const Argument& argument : arguments) {
        const std::array<Rational, 2> factor{argument.mass, argument.u};
        coefficients *= Polynomial(factor);
    }
    std::vector<Rational> values;
    for (std::size_t k = 0; k <= arguments.size(); ++k) values.push_back(coefficients[k]);
    return values;
}

std::vector<std::vector<std::size_t>> subsets_of_size(std::size_t n, std::size_t k) {
    std::vector<std::size_t> subset(k);
    std::iota(subset.begin(), subset.end(), std::size_t{0});
    std::vector<std::vector<std::size_t>> subsets;
    while (true) {
        subsets.push_back(subset);
        std::size_t place = k;
        while (place > 0 && subset[place - 1] == n - k + place - 1) --place;
        if (place == 0) return subsets;
        ++subset[place - 1];
        for (std::size_t i = place; i < k; ++i) subset[i] = subset[i - 1] + 1;
    }
}

}  // namespace blossom::worked
