#include "symbols.hpp"

#include <algorithm>
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

}  // namespace blossom::worked
