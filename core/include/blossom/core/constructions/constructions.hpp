#pragma once

#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/row_recurrences.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

/// The three constructions of a blossom as templates over any commutative ring R that contains the integers:
/// the same code runs on integers (values) and on symbolic polynomials (proofs for all arguments). None of
/// them divides: a result is numerators in R over one integer.

namespace blossom {

/// A homogeneous argument over R: (u, 1) is a point, (u, 0) a vector.
template <class R>
struct HomogeneousPair {
    R u;
    R mass;

    friend bool operator==(const HomogeneousPair&, const HomogeneousPair&) = default;
};

/// A value in R^d, divided by a denominator.
template <class R>
struct Quotients {
    std::vector<R> numerators;
    Integer denominator = 1;
};

/// One row per coordinate.
template <class R>
using Rows = std::span<const std::span<const R>>;

namespace constructions {

/// c_k / C(n, k) for k = 0..n as numerators over the least common multiple of the binomials: the values
/// p(0^(n-k), delta^k). Source: Goldman, equation (4.4). Statement: goldman-eq44.
template <class R>
Quotients<R> normalised_coefficients(std::span<const R> coefficients) {
    const std::size_t n = coefficients.size() - 1;
    Quotients<R> result{{}, binomial_row_lcm(n)};
    const std::vector<Integer> binomials = binomial_row(n);
    result.numerators.reserve(n + 1);
    for (std::size_t k = 0; k <= n; ++k) {
        result.numerators.push_back(coefficients[k] * R(divide_exactly(result.denominator, binomials[k])));
    }
    return result;
}

/// The blossom by elementary symmetric functions: p(u_1..u_n) = sum_k c_k e_k(u) / C(n, k).
///
/// `coefficients`: n + 1 monomial coefficients per coordinate, lowest first; n arguments.
/// Cost: n^2 / 2 multiply-adds for the e_k, n per coordinate.
/// Source: Goldman, proposition 1; DeRose, equation (3). Statements: goldman-prop1, derose-eq3, goldman-thm2.
template <class R>
Quotients<R> by_symmetric_functions(Rows<R> coefficients, std::span<const HomogeneousPair<R>> arguments) {
    std::vector<R> masses;
    std::vector<R> parameters;
    for (const auto& argument : arguments) {
        masses.push_back(argument.mass);
        parameters.push_back(argument.u);
    }
    const std::vector<R> functions =
        product_of_linear_factors(std::span<const R>(masses), std::span<const R>(parameters));
    Quotients<R> result;
    for (const auto row : coefficients) {
        Quotients<R> normalised = normalised_coefficients(row);
        result.denominator = std::move(normalised.denominator);
        result.numerators.push_back(
            dot(std::span<const R>(normalised.numerators), std::span<const R>(functions)));
    }
    return result;
}

inline void accumulate_product(Integer& sum, const Integer& a, const Integer& b) { sum.add_product(a, b); }
template <class R>
void accumulate_product(R& sum, const R& a, const R& b) {
    sum += a * b;
}

/// Distinct arguments with their multiplicities.
template <class Argument>
using Groups = std::vector<std::pair<Argument, std::size_t>>;

/// Groups equal arguments.
template <class Argument>
Groups<Argument> grouped(std::span<const Argument> arguments) {
    Groups<Argument> groups;
    for (const Argument& argument : arguments) {
        const auto same = std::ranges::find(groups, argument, [](const auto& group) { return group.first; });
        if (same == groups.end()) {
            groups.emplace_back(argument, 1);
        } else {
            ++same->second;
        }
    }
    return groups;
}

/// sum += argument, entry by entry.
template <class R>
void add_argument(HomogeneousPair<R>& sum, const HomogeneousPair<R>& argument) {
    sum.u += argument.u;
    sum.mass += argument.mass;
}
template <class R>
void add_argument(std::vector<R>& sum, const std::vector<R>& argument) {
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += argument[k];
}

/// The sum over all sub-multisets S of `groups` of (-1)^(n-|S|) * prod C(m_i, j_i) * term(partial + sum of S,
/// size + |S|), by halves: the partial sums stay of similar size, and those of a symbolic ring cancel early.
/// A term without entries is zero.
template <class R, class Argument, class Term>
std::vector<R> alternating_sum(std::span<const std::pair<Argument, std::size_t>> groups,
                               const Argument& partial, std::size_t size, const Term& term) {
    if (groups.empty()) return term(partial, size);
    const auto& [argument, multiplicity] = groups.front();
    std::vector<R> total;
    Argument sum = partial;
    Integer binomial = 1;
    for (std::size_t j = 0; j <= multiplicity; ++j) {
        // The partial sum changes its sign in each step.
        std::vector<R> values = alternating_sum<R, Argument>(groups.subspan(1), sum, size + j, term);
        if (values.size() < total.size()) values.resize(total.size(), R(0));
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (!binomial.is_one()) values[i] *= R(binomial);
            if (i < total.size()) values[i] -= total[i];
        }
        total = std::move(values);
        if (j == multiplicity) break;
        add_argument(sum, argument);
        binomial = divide_exactly(binomial * Integer(multiplicity - j), Integer(j + 1));
    }
    return total;
}

/// The blossom by the polarization inverse formula, which only evaluates the polynomial: (1/n!) sum over
/// subsets S of (-1)^(n-|S|) F(sum of S), where F(u, v) = v^n P(u/v) is the homogeneous polynomial. For
/// points this is the affine form (1/n!) sum_N (-1)^(n-N) N^n sum P(mean of N arguments).
///
/// `form(pair)` gives F, one entry per coordinate. The empty subset contributes only for n = 0, where F is
/// constant. Cost: prod(m_i + 1) evaluations, m_i the multiplicities of the arguments; 2^n for distinct ones.
/// Source: Fernandez-Jambrina, theorem 1 and corollary 1, equations (18) and (20). Statements: fj-thm1,
/// fj-cor1.
template <class R, class Form>
Quotients<R> by_polarization(Form&& form, std::span<const HomogeneousPair<R>> arguments) {
    const auto groups = grouped(arguments);
    const auto term = [&](const HomogeneousPair<R>& sum, std::size_t) { return form(sum); };
    return {alternating_sum<R, HomogeneousPair<R>>(groups, {R(0), R(0)}, 0, term),
            factorial(arguments.size())};
}

/// sum_S (-1)^(n-|S|) (sum of S)^k over the subsets S of the arguments with N points, k = 0..n, for each N;
/// computed one argument after the other by (s + u)^k = sum_j C(k, j) u^(k-j) s^j.
///
/// Cost: n^4 / 4 multiply-adds.
template <class R>
std::vector<std::vector<R>> signed_power_sums(std::span<const HomogeneousPair<R>> arguments) {
    const std::size_t n = arguments.size();
    std::vector<std::vector<Integer>> binomials;
    for (std::size_t k = 0; k <= n; ++k) binomials.push_back(binomial_row(k));
    std::vector<std::vector<R>> sums(1, std::vector<R>(n + 1, R(0)));
    sums[0][0] = R(1);
    for (const auto& [u, mass] : arguments) {
        std::vector<R> powers{R(1)};
        for (std::size_t k = 0; k < n; ++k) powers.push_back(powers.back() * u);
        const bool point = !(mass == R(0));
        if (point) sums.emplace_back(n + 1, R(0));
        for (std::size_t points = sums.size(); points-- > 0;) {
            for (std::size_t k = n + 1; k-- > 0;) {
                R larger(0);
                if (!point || points > 0) {
                    const std::vector<R>& smaller = sums[point ? points - 1 : points];
                    for (std::size_t j = 0; j <= k; ++j)
                        accumulate_product(larger, R(binomials[k][j]) * powers[k - j], smaller[j]);
                }
                sums[points][k] = larger - sums[points][k];
            }
        }
    }
    return sums;
}

/// The polarization inverse formula with the terms of equal numbers of points combined: those of N points are
/// sum_k c_k (N mass)^(n-k) sum_S (-1)^(n-|S|) (sum of S)^k, so that power sums over subsets suffice and no
/// single subset is enumerated.
///
/// `coefficients`: n + 1 monomial coefficients per coordinate, lowest first; all nonzero masses are equal.
/// Cost: n^4 / 4 multiply-adds. Source: Fernandez-Jambrina, equation (20). Statement: fj-cor1.
template <class R>
Quotients<R> by_regrouped_polarization(Rows<R> coefficients, std::span<const HomogeneousPair<R>> arguments) {
    const auto has_mass = [](const HomogeneousPair<R>& argument) { return !(argument.mass == R(0)); };
    const auto point = std::ranges::find_if(arguments, has_mass);
    const R mass = point == arguments.end() ? R(0) : point->mass;
    const std::vector<std::vector<R>> sums = signed_power_sums(arguments);
    Quotients<R> result{{}, factorial(arguments.size())};
    for (const auto row : coefficients) {
        R total(0);
        for (std::size_t points = 0; points < sums.size(); ++points) {
            const R scale = R(Integer(points)) * mass;
            R power(1);
            for (std::size_t k = row.size(); k-- > 0;) {
                accumulate_product(total, row[k] * power, sums[points][k]);
                power = power * scale;
            }
        }
        result.numerators.push_back(std::move(total));
    }
    return result;
}

/// The blossom by de Casteljau's algorithm with one argument per level, from control points over [a/q, b/q]:
/// on the level of (u, v), neighbours are combined with the weights left / (b - a) and right / (b - a), where
/// left = b v - q u and right = q u - a v.
///
/// Cost: n^2 / 2 multiply-adds per coordinate.
/// Source: DeRose, figure 6; Goldman, figures 3 and 7. Statements: derose-fig6, goldman-fig3, goldman-fig7.
template <class R>
Quotients<R> by_casteljau(Rows<R> control_points, const Integer& a, const Integer& b, const Integer& q,
                          std::span<const HomogeneousPair<R>> arguments) {
    std::vector<R> left;
    std::vector<R> right;
    for (const auto& [u, mass] : arguments) {
        left.push_back(R(b) * mass - R(q) * u);
        right.push_back(R(q) * u - R(a) * mass);
    }
    Quotients<R> result{{}, pow(b - a, arguments.size())};
    for (const auto row : control_points) {
        result.numerators.push_back(fold_triangle(std::vector<R>(row.begin(), row.end()),
                                                  std::span<const R>(left), std::span<const R>(right)));
    }
    return result;
}

/// sum_k c_k x^k by Horner's rule.
template <class R>
R polynomial_value(std::span<const R> coefficients, const R& x) {
    R value = coefficients.back();
    for (std::size_t k = coefficients.size() - 1; k-- > 0;) {
        value *= x;
        value += coefficients[k];
    }
    return value;
}

/// sum_k c_k x^k y^(n-k) by Horner's rule.
template <class R>
R form_value(std::span<const R> coefficients, const R& x, const R& y) {
    R value = coefficients.back();
    R power = y;
    for (std::size_t k = coefficients.size() - 1; k-- > 0;) {
        value *= x;
        value += coefficients[k] * power;
        power *= y;
    }
    return value;
}

}  // namespace constructions

}  // namespace blossom
