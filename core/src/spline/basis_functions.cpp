#include <blossom/core/spline/basis_functions.hpp>
#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>

#include "blossom/run_construction.hpp"
#include "divided_rows.hpp"
#include "maps/change_of_interval.hpp"
#include "maps/stated_points.hpp"

namespace blossom {

namespace {

/// The n + 2 knots of a basis function: the window and one more knot at each end. In the polar convention,
/// the first and the last function lack one of these; no span of the domain depends on it.
std::vector<Rational> knots_of(const KnotVector& knots, std::size_t point) {
    const auto window = knots.window(point);
    const std::size_t begin = knots.window_index(point);
    const std::size_t end = begin + window.size();
    std::vector<Rational> result;
    result.reserve(window.size() + 2);
    result.push_back(begin > 0 ? knots[begin - 1] : knots[0] - Rational(1));
    result.insert(result.end(), window.begin(), window.end());
    result.push_back(end < knots.size() ? knots[end] : knots[end - 1] + Rational(1));
    return result;
}

/// The polynomial in t by which the basis function over `knots` decreases where t passes the knot k =
/// knots[last], the last of its m copies.
///
/// N(t) = (t_(n+1) - t_0) [t_0, ..., t_(n+1)] (y - t)_+^n is a divided difference in y. The knot k
/// contributes sum_v A_v C(n, v) (k - t)^(n-v), v = 0..m-1, where sum_v A_v / z^(v+1) is the singular part of
/// 1 / prod_i (k + z - t_i).
Polynomial jump(const RationalVector& knots, std::size_t last, std::size_t multiplicity,
                const std::vector<Integer>& binomials) {
    const std::vector<Integer>& all = knots.numerators();
    const std::size_t n = all.size() - 2;
    Integer product = 1;  // of the differences from the other knots
    Integer common = 1;   // a multiple of each of them
    std::vector<Integer> differences;
    for (const Integer& knot : all) {
        if (knot == all[last]) continue;
        differences.push_back(all[last] - knot);
        product *= differences.back();
        if (multiplicity > 1) common = lcm(common, differences.back());
    }
    // 1 / prod (1 + common z / difference) up to z^(m-1)
    std::vector<Integer> series(multiplicity);
    series[0] = 1;
    for (std::size_t i = 0; multiplicity > 1 && i < differences.size(); ++i) {
        const Integer slope = -divide_exactly(common, differences[i]);
        for (std::size_t j = 1; j < multiplicity; ++j) series[j].add_product(slope, series[j - 1]);
    }
    // In powers of t - k; the differences are integers over the denominator of the knots.
    std::vector<Integer> powers(n + 1);
    Integer scale = (all.back() - all.front()) * pow(knots.denominator(), n);
    for (std::size_t v = 0; v < multiplicity; ++v) {
        powers[n - v] = series[multiplicity - 1 - v] * binomials[v] * scale;
        if ((n - v) % 2 == 1) powers[n - v].negate();
        if (v < n) scale = divide_exactly(scale * common, knots.denominator());
    }
    auto [numerators, denominator] = taylor_coefficients(powers, -knots[last]);
    return Polynomial(
        RationalVector(std::move(numerators), denominator * product * pow(common, multiplicity - 1)));
}

}  // namespace

std::vector<PolynomialPiece> basis_function(const KnotVector& knots, std::size_t point,
                                            const Limits& limits) {
    if (point >= knots.points()) {
        throw Error(ErrorCode::wrong_arity, "there is no control point " + std::to_string(point) +
                                                "; their number is " + std::to_string(knots.points()));
    }
    const std::size_t n = knots.degree();
    require_within(n, limits.degree, "degree", "the formal degree", Part::degree);
    const std::size_t first = knots.begin_index() + point - std::min(point, n);
    const std::size_t last = std::min(knots.begin_index() + point, knots.end_index() - 1);
    const std::vector<Rational> own = knots_of(knots, point);
    const RationalVector integers(own);
    const std::vector<Integer> binomials = binomial_row(n);
    std::vector<PolynomialPiece> pieces;
    Polynomial sum;
    std::size_t behind = own.size();
    for (std::size_t span = last + 1; span-- > first;) {
        if (knots[span] == knots[span + 1]) continue;
        while (behind > 0 && knots[span] < own[behind - 1]) {
            std::size_t multiplicity = 1;
            while (multiplicity < behind && own[behind - 1 - multiplicity] == own[behind - 1]) ++multiplicity;
            sum += jump(integers, behind - 1, multiplicity, binomials);
            behind -= multiplicity;
        }
        require_result_bits(std::max(greatest_bit_length(sum.coefficients().numerators()),
                                     sum.coefficients().denominator().bit_length()),
                            limits, (n + 1) * (pieces.size() + 1));
        pieces.push_back({span, Interval(knots[span], knots[span + 1]), sum});
    }
    std::ranges::reverse(pieces);
    return pieces;
}

KnotVector knots_around(std::size_t degree, std::span<const Rational> own) {
    if (own.size() != degree + 2) {
        throw Error(ErrorCode::wrong_arity,
                    "a B-spline of degree " + std::to_string(degree) + " has " + std::to_string(degree + 2) +
                        " knots, not " + std::to_string(own.size()),
                    Part::knots);
    }
    require_knots(own, degree);
    std::vector<Rational> knots;
    knots.reserve(own.size() + 2 * degree);
    for (std::size_t i = 0; i < degree; ++i) knots.push_back(own.front() - Rational(degree - i));
    knots.insert(knots.end(), own.begin(), own.end());
    for (std::size_t i = 0; i < degree; ++i) knots.push_back(own.back() + Rational(i + 1));
    return {degree, std::move(knots), 2 * degree + 1};
}

BasisValues blossom_weights(const KnotVector& knots, std::size_t span, std::span<const Argument> arguments,
                            const Limits& limits) {
    const std::size_t n = knots.degree();
    require_within(n, limits.degree, "degree", "the formal degree", Part::degree);
    require_arity(n, arguments.size());
    knots.require_span(span);
    const RationalVector around(knots.around(span));
    const std::vector<Integer>& all = around.numerators();
    std::vector<std::vector<Integer>> row{{1}};
    std::vector<Integer>& values = row.front();
    Integer denominator = 1;
    for (std::size_t degree = 0; degree < n; ++degree) {
        const std::size_t begin = n - 1 - degree;
        const auto& [u, v] = arguments[begin];
        const Integer parameter = around.denominator() * u.numerator() * v.denominator();
        const Integer mass = v.numerator() * u.denominator();
        const Integer cleared = u.denominator() * v.denominator();
        std::vector<Integer> divisors;
        for (std::size_t r = 0; r <= degree; ++r) divisors.push_back((all[n + r] - all[begin + r]) * cleared);
        denominator *= divide_entries(row, divisors);
        values.emplace_back(0);
        for (std::size_t r = degree + 1; r-- > 0;) {
            values[r + 1].add_product(parameter - all[begin + r] * mass, values[r]);
            values[r] *= all[n + r] * mass - parameter;
        }
        require_result_bits(std::max(greatest_bit_length(values), denominator.bit_length()), limits);
    }
    BasisValues result{knots.first_point(span), {}};
    for (Integer& value : values) result.values.emplace_back(std::move(value), denominator);
    return result;
}

BasisValues basis_values(const KnotVector& knots, const Rational& t, const Limits& limits) {
    return basis_derivatives(knots, 0, t, limits);
}

BasisValues basis_derivatives(const KnotVector& knots, std::size_t order, const Rational& t,
                              const Limits& limits) {
    const std::size_t n = knots.degree();
    const std::size_t span = knots.span_at(t);
    if (order > n) return {knots.first_point(span), std::vector<Rational>(n + 1)};
    BasisValues result = blossom_weights(knots, span, two_arguments(n, order, Parameter(t), delta), limits);
    if (order > 0) {
        for (Rational& value : result.values) value *= falling_factorial(n, order);
    }
    return result;
}

}  // namespace blossom
