#include "curve_pair.hpp"

#include <blossom/core/algebra/elimination.hpp>

#include <algorithm>

namespace blossom {

namespace {

/// x(s) z(t) - u(t) w(s) by its coefficients in t.
PolynomialRows rows_in_t(const Polynomial& x, const Polynomial& w, const Polynomial& u, const Polynomial& z) {
    PolynomialRows rows;
    for (std::size_t k = 0; k <= std::max(u.degree(), z.degree()); ++k)
        rows.push_back(x * Polynomial(z[k]) - w * Polynomial(u[k]));
    return rows;
}

/// (x(s) w(t) - x(t) w(s)) / (s - t): the coefficients x_a w_b - x_b w_a of s^a t^b - s^b t^a, divided.
PolynomialRows divided_rows_of(const Polynomial& x, const Polynomial& w) {
    const std::size_t n = std::max(x.degree(), w.degree());
    std::vector<std::vector<Rational>> rows(n, std::vector<Rational>(n));
    for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = a + 1; b <= n; ++b) {
            const Rational factor = x[b] * w[a] - x[a] * w[b];
            for (std::size_t i = 0; i < b - a; ++i) rows[a + i][b - 1 - i] += factor;
        }
    }
    PolynomialRows result;
    for (const std::vector<Rational>& row : rows) result.emplace_back(row);
    return result;
}

bool is_zero(const PolynomialRows& rows) { return std::ranges::all_of(rows, &Polynomial::is_zero); }

Polynomial eliminated(const PolynomialRows (&equations)[2], const Polynomial& weight, const Limits& limits) {
    const bool one_is_zero = is_zero(equations[0]);
    const PolynomialRows& f = equations[one_is_zero ? 1 : 0];
    const PolynomialRows& g = equations[is_zero(equations[1]) ? 0 : 1];
    return without_factors_of(resultant(f, g, limits), weight);
}

}  // namespace

PairEquations equations_of_common_points(const CurvePiece& first, const CurvePiece& second) {
    PairEquations equations;
    for (std::size_t j = 0; j < 2; ++j) {
        const Polynomial& x = first.coordinates[j];
        const Polynomial& u = second.coordinates[j];
        equations.in_t[j] = rows_in_t(x, first.weight(), u, second.weight());
        equations.in_s[j] = rows_in_t(u, second.weight(), x, first.weight());
    }
    return equations;
}

PairEquations equations_of_double_points(const CurvePiece& curve) {
    PairEquations equations;
    for (std::size_t j = 0; j < 2; ++j)
        equations.in_t[j] = equations.in_s[j] = divided_rows_of(curve.coordinates[j], curve.weight());
    return equations;
}

Polynomial equation_of_first(const PairEquations& equations, const CurvePiece& first, const Limits& limits) {
    return eliminated(equations.in_t, first.weight(), limits);
}

Polynomial equation_of_second(const PairEquations& equations, const CurvePiece& second,
                              const Limits& limits) {
    return eliminated(equations.in_s, second.weight(), limits);
}

std::vector<Root> roots_in(const CurvePiece& piece, const Polynomial& polynomial, const Rational& width,
                           const Limits& limits) {
    const RangedPolynomial one{polynomial, piece.range, piece.closed};
    return roots(std::span(&one, 1), width, limits).roots;
}

bool is_point(const CurvePiece& piece) {
    return std::ranges::all_of(piece.coordinates, [](const Polynomial& p) { return p.degree() == 0; });
}

PointComparison::PointComparison(const CurvePiece& first, const CurvePiece& second, const Limits& limits)
    : first_(first), second_(second), limits_(limits) {
    for (std::size_t j = 0; j < 2; ++j) {
        coordinates_[0].emplace_back(first.coordinates[j], first.weight(), limits);
        coordinates_[1].emplace_back(second.coordinates[j], second.weight(), limits);
    }
}

bool PointComparison::is_excluded(Root s, Root t) const {
    constexpr int rounds = 3;
    constexpr std::size_t bits_of_round = 24;
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t j = 0; j < 2; ++j) {
            const auto [low, high] = coordinates_[0][j].bounds_at(s);
            const auto [least, greatest] = coordinates_[1][j].bounds_at(t);
            if (high < least || greatest < low) return true;
        }
        const Rational part(1, Integer(1) << bits_of_round);
        s = narrowed(s, (s.upper - s.lower) * part, limits_);
        t = narrowed(t, (t.upper - t.lower) * part, limits_);
    }
    return false;
}

bool PointComparison::have_same_value(const Quotient& of_first, const Quotient& of_second,
                                      AlgebraicValues& at_first, AlgebraicValues& at_second, const Root& s,
                                      const Root& t) const {
    if (s.is_rational()) {
        const Rational value = of_first.numerator(s.lower) / of_first.denominator(s.lower);
        return vanishes_at(of_second.numerator - of_second.denominator * Polynomial(value), t);
    }
    if (t.is_rational()) {
        const Rational value = of_second.numerator(t.lower) / of_second.denominator(t.lower);
        return vanishes_at(of_first.numerator - of_first.denominator * Polynomial(value), s);
    }
    return is_same(at_first.at(s), at_second.at(t), limits_);
}

bool PointComparison::have_same_value(const Quotient& of_first, const Quotient& of_second, const Root& s,
                                      const Root& t) const {
    AlgebraicValues at_first(of_first.numerator, of_first.denominator, limits_);
    AlgebraicValues at_second(of_second.numerator, of_second.denominator, limits_);
    return have_same_value(of_first, of_second, at_first, at_second, s, t);
}

bool PointComparison::meet(const Root& s, const Root& t) {
    if (vanishes_at(first_.weight(), s) || vanishes_at(second_.weight(), t) || is_excluded(s, t))
        return false;
    for (std::size_t j = 0; j < 2; ++j) {
        if (!have_same_value({first_.coordinates[j], first_.weight()},
                             {second_.coordinates[j], second_.weight()}, coordinates_[0][j],
                             coordinates_[1][j], s, t))
            return false;
    }
    return true;
}

std::size_t PointComparison::multiplicity(const Root& s, const Root& t, std::optional<std::size_t> most) {
    const Root parameters[] = {s, t};
    bool is_vertical[2];
    for (std::size_t i = 0; i < 2; ++i) {
        is_vertical[i] = vanishes_at(velocity_[i][0], parameters[i]);
        if (is_vertical[i] && vanishes_at(velocity_[i][1], parameters[i])) return 0;
    }
    if (is_vertical[0] != is_vertical[1]) return 1;
    // One coordinate as a function of the other, by its derivatives: (dy/dx)' = (dy/dx)^. / x^. with the
    // derivatives by the parameter, x^. = v / w^2.
    const std::size_t along = is_vertical[0] ? 1 : 0;
    Quotient derivatives[2];
    for (std::size_t i = 0; i < 2; ++i) derivatives[i] = {velocity_[i][1 - along], velocity_[i][along]};
    for (std::size_t multiplicity = 1;; ++multiplicity) {
        if (!have_same_value(derivatives[0], derivatives[1], s, t)) return multiplicity;
        if (multiplicity == most) return 0;
        for (std::size_t i = 0; i < 2; ++i) {
            auto& [numerator, denominator] = derivatives[i];
            const Polynomial& weight = (i == 0 ? first_ : second_).weight();
            Polynomial next =
                (derivative(numerator) * denominator - numerator * derivative(denominator)) * weight * weight;
            Polynomial below = denominator * denominator * velocity_[i][along];
            const Polynomial common = gcd(next, below);
            numerator = divide_exactly(next, common);
            denominator = divide_exactly(below, common);
        }
    }
}

}  // namespace blossom
