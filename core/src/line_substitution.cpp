#include "line_substitution.hpp"

#include <blossom/rational/taylor_shift.hpp>

#include <algorithm>

#include "binomial_weights.hpp"

namespace blossom {

std::vector<Integer> powers(const Integer& base, std::size_t n) {
    std::vector<Integer> result{1};
    result.reserve(n + 1);
    for (std::size_t k = 0; k < n; ++k) result.push_back(result.back() * base);
    return result;
}

// With X = (a / d) Y the line is a (1 + Y): shift c_k a^k q^(n-k) by one, and undo the scaling.
std::vector<Integer> substitute_line(std::span<const Integer> coefficients, const Integer& a,
                                     const Integer& d, const Integer& q) {
    const std::size_t n = coefficients.size() - 1;
    std::vector<Integer> result(coefficients.begin(), coefficients.end());
    const auto scale = [&](const std::vector<Integer>& factors, bool reversed) {
        for (std::size_t k = 0; k <= n; ++k) result[k] *= factors[reversed ? n - k : k];
    };
    if (!q.is_one()) scale(powers(q, n), true);
    if (!a.is_zero()) {
        const std::vector<Integer> powers_of_a = powers(a, a.is_one() ? 0 : n);
        if (!a.is_one()) scale(powers_of_a, false);
        result = shifted_by_one(result);
        if (!a.is_one()) {
            for (std::size_t k = 1; k <= n; ++k) result[k] = divide_exactly(result[k], powers_of_a[k]);
        }
    }
    if (!d.is_one()) scale(powers(d, n), false);
    return result;
}

Quotients<Integer> bernstein_from_monomial(std::span<const Integer> coefficients, const Integer& a,
                                           const Integer& b, const Integer& q) {
    const std::size_t n = coefficients.size() - 1;
    std::vector<Integer> form = substitute_line(coefficients, a, b - a, q);
    std::ranges::reverse(form);
    form = shifted_by_one(form);
    std::ranges::reverse(form);
    const auto weights = binomial_weights(n);
    for (std::size_t k = 0; k <= n; ++k) form[k] *= weights->numerators[k];
    return {std::move(form), weights->denominator * pow(q, n)};
}

}  // namespace blossom
