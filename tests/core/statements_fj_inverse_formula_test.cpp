// Fernandez-Jambrina: Inverse Relations for Blossoms and Parametrisations of Rational Curves and Surfaces
// (2024), section 4: control points from the parametrisation.
//
// Coefficients and the ends of the interval are symbols: each case decides its statement for all curves and
// intervals, at the degrees that it names.

#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/curve/degree_reduction.hpp>
#include <blossom/core/curve/inverse_formula.hpp>
#include <blossom/rational/combinatorics.hpp>

#include <algorithm>

#include "support/map_printing.hpp"
#include "support/symbolic_curves.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

struct Generic {
    Variables variables;
    Symbols c;
    SymbolicBlossom blossom;
    Symbol alpha;
    Symbol beta;

    explicit Generic(std::size_t n)
        : c(variables.next(n + 1)),
          blossom(SymbolicBlossom::of_coefficients(c)),
          alpha(variables.next()),
          beta(variables.next()) {}

    Symbol curve(const Symbol& t) const { return polynomial_value(c, t); }
    /// b at the point that divides [alpha, beta] as `share` divides [0, 1].
    Symbol at(const Rational& share) const { return curve(alpha * Symbol(1 - share) + beta * Symbol(share)); }

    /// The right-hand side of equation (22), as printed, for degree n.
    Symbol equation22(std::size_t n, std::size_t i) const {
        Symbols terms;
        for (std::size_t count = 1; count <= n; ++count) {
            for (std::size_t at_beta = 0; at_beta <= std::min(i, count); ++at_beta) {
                const Integer factor =
                    pow(Integer(count), n) * binomial(i, at_beta) * binomial(n - i, count - at_beta);
                const Symbol term = scaled(factor, at(Rational(at_beta, count)));
                terms.push_back((n - count) % 2 == 0 ? term : -term);
            }
        }
        return sum(terms) * fraction(1, factorial(n));
    }
    /// The combination of values at the nodes that the engine's table gives.
    Symbol tabled(const InverseFormula& formula, std::size_t i) const {
        Symbols terms;
        for (std::size_t j = 0; j < formula.nodes.size(); ++j)
            terms.push_back(formula.weights[i][j] * at(formula.nodes[j]));
        return sum(terms);
    }
};

/// Row i of the table of degree n as (share of the way from alpha to beta, weight), without zeros.
using Terms = std::vector<std::pair<Rational, Rational>>;

Terms row(std::size_t n, std::size_t i) {
    const InverseFormula formula = inverse_formula(n, {});
    Terms terms;
    for (std::size_t j = 0; j < formula.nodes.size(); ++j) {
        if (!formula.weights[i][j].is_zero()) terms.emplace_back(formula.nodes[j], formula.weights[i][j]);
    }
    return terms;
}

Terms mirrored(Terms terms) {
    std::ranges::reverse(terms);
    for (auto& [share, weight] : terms) share = 1 - share;
    return terms;
}

Rational r(int p, int q = 1) { return {p, q}; }

/// For every node, the weights with which the values at the nodes enter the value of the reduced curve there.
std::vector<std::vector<Rational>> values_at_nodes(std::size_t n) {
    const InverseFormula formula = inverse_formula(n, {});
    std::vector<std::vector<Rational>> result;
    for (const Rational& t : formula.nodes) {
        std::vector<Rational> weights(formula.nodes.size());
        for (std::size_t i = 0; i <= n; ++i) {
            const Rational basis = Rational(binomial(n, i)) * pow(t, i) * pow(1 - t, n - i);
            for (std::size_t j = 0; j < weights.size(); ++j) weights[j] += basis * formula.weights[i][j];
        }
        result.push_back(std::move(weights));
    }
    return result;
}

BezierCurve power_over(std::size_t exponent, const Interval& interval) {
    return control_points(PolynomialCurve(Polynomial::monomial(exponent)), interval);
}

}  // namespace

TEST_CASE("fj-eq22: the vertices on [alpha,beta] from values at ((N-I) alpha + I beta) / N, n = 1..5, all i",
          "[statement]") {
    for (std::size_t n = 1; n <= 5; ++n) {
        const Generic g(n);
        const InverseFormula formula = inverse_formula(n, {});
        for (std::size_t i = 0; i <= n; ++i) {
            const Symbol vertex = g.blossom(runs(n - i, g.alpha, i, g.beta));
            CHECK(g.equation22(n, i) == vertex);
            CHECK(g.tabled(formula, i) == vertex);
        }
    }
}

TEST_CASE(
    "fj-eq22-binom: for 0 <= I <= i the binomial C(n-i,N-I) is not zero exactly when 0 <= N-I <= n-i, n <= "
    "12",
    "[statement]") {
    for (std::size_t n = 1; n <= 12; ++n) {
        for (std::size_t i = 0; i <= n; ++i) {
            for (std::size_t count = 1; count <= n; ++count) {
                for (std::size_t at_beta = 0; at_beta <= std::min(i, count); ++at_beta) {
                    CHECK(binomial(n - i, count - at_beta).is_zero() == (count - at_beta > n - i));
                }
            }
        }
    }
}

TEST_CASE("fj-eq22-n2: the weights of degree 2", "[statement]") {
    CHECK(row(2, 0) == Terms{{0, 1}});
    CHECK(row(2, 1) == Terms{{0, r(-1, 2)}, {r(1, 2), 2}, {1, r(-1, 2)}});
    CHECK(row(2, 2) == Terms{{1, 1}});
}

TEST_CASE("fj-eq22-n3: the weights of degree 3", "[statement]") {
    CHECK(row(3, 0) == Terms{{0, 1}});
    CHECK(row(3, 1) == Terms{{0, -1}, {r(1, 3), r(9, 2)}, {r(1, 2), r(-8, 3)}, {1, r(1, 6)}});
    CHECK(row(3, 2) == Terms{{0, r(1, 6)}, {r(1, 2), r(-8, 3)}, {r(2, 3), r(9, 2)}, {1, -1}});
    CHECK(row(3, 3) == Terms{{1, 1}});
}

TEST_CASE("fj-eq22-n4: the weights of degree 4", "[statement]") {
    CHECK(row(4, 0) == Terms{{0, 1}});
    const Terms first{{0, r(-3, 2)}, {r(1, 4), r(32, 3)}, {r(1, 3), r(-81, 8)}, {r(1, 2), 2}, {1, r(-1, 24)}};
    CHECK(row(4, 1) == first);
    CHECK(
        row(4, 2) ==
        Terms{{0, r(7, 12)}, {r(1, 3), r(-27, 4)}, {r(1, 2), r(40, 3)}, {r(2, 3), r(-27, 4)}, {1, r(7, 12)}});
    CHECK(row(4, 3) == mirrored(first));
    CHECK(row(4, 4) == Terms{{1, 1}});
}

TEST_CASE(
    "fj-formal-degree: the formula of degree m gives the raised vertices of degree d, d <= 3, m = d..d+2",
    "[statement]") {
    for (std::size_t d = 0; d <= 3; ++d) {
        for (std::size_t m = std::max<std::size_t>(d, 1); m <= d + 2; ++m) {
            const Generic g(d);
            Symbols raised = g.c;
            raised.resize(m + 1, 0);
            for (std::size_t i = 0; i <= m; ++i) {
                CHECK(g.equation22(m, i) == by_symmetric_functions(raised, runs(m - i, g.alpha, i, g.beta)));
            }
        }
    }
}

TEST_CASE("fj-restriction: the vertices of (22) control b on any [alpha,beta], n = 1..4", "[statement]") {
    for (std::size_t n = 1; n <= 4; ++n) {
        Generic g(n);
        const Symbol t = g.variables.next();
        Symbols vertices;
        for (std::size_t i = 0; i <= n; ++i) vertices.push_back(g.equation22(n, i));
        CHECK(bezier_value(vertices, g.alpha, g.beta, t) == pow(g.beta - g.alpha, n) * g.curve(t));
    }
}

TEST_CASE("fj-reduction-endpoints: b_0 = b(alpha) and b_n = b(beta) for every map, n = 1..9", "[statement]") {
    for (std::size_t n = 1; n <= 9; ++n) {
        CHECK(row(n, 0) == Terms{{0, 1}});
        CHECK(row(n, n) == Terms{{1, 1}});
    }
}

TEST_CASE("fj-reduction-symmetric: the weights of b_i are those of b_(n-i) from the other end, n = 1..9",
          "[statement]") {
    for (std::size_t n = 1; n <= 9; ++n) {
        for (std::size_t i = 0; i <= n; ++i) CHECK(row(n, i) == mirrored(row(n, n - i)));
    }
}

TEST_CASE("fj-reduction-exact: exact for curves of the same or a lower degree, n = 1..5", "[statement]") {
    for (std::size_t n = 1; n <= 5; ++n) {
        for (std::size_t d = 0; d <= n; ++d) {
            const BezierCurve curve = elevate(power_over(d, {-2, r(3, 5)}), 7 - d);
            const Reduction reduction = reduce(curve, n, ReductionMethod::inverse_formula);
            CHECK(reduction.exact);
            CHECK(reduction.l2_squared == 0);
            CHECK(reduction.curve == elevate(power_over(d, {-2, r(3, 5)}), n - d));
        }
        CHECK_FALSE(reduce(power_over(n + 1, {}), n, ReductionMethod::inverse_formula).exact);
    }
}

TEST_CASE("fj-reduction-is-lagrange: true for n = 2 only; for n = 3..6 nothing but the ends is interpolated",
          "[statement]") {
    const std::vector<std::size_t> node_counts{0, 2, 3, 5, 7, 11, 13};
    for (std::size_t n = 2; n <= 6; ++n) {
        const auto values = values_at_nodes(n);
        REQUIRE(values.size() == node_counts[n]);
        std::vector<std::size_t> interpolated;
        for (std::size_t j = 0; j < values.size(); ++j) {
            std::vector<Rational> unit(values.size());
            unit[j] = 1;
            if (values[j] == unit) interpolated.push_back(j);
        }
        CHECK(interpolated ==
              (n == 2 ? std::vector<std::size_t>{0, 1, 2} : std::vector<std::size_t>{0, values.size() - 1}));
    }
    // b~(1/2) - b(1/2) for n = 3, on the values at 0, 1/3, 1/2, 2/3, 1.
    std::vector<Rational> defect = values_at_nodes(3)[2];
    defect[2] -= 1;
    CHECK(defect == std::vector<Rational>{r(-3, 16), r(27, 16), -3, r(27, 16), r(-3, 16)});

    const BezierCurve reduced = reduce(power_over(4, {}), 3, ReductionMethod::inverse_formula).curve;
    const Polynomial cubic = monomial_form(reduced).coordinate(0);
    CHECK(cubic(r(1, 3)) == 0);
    CHECK(cubic(r(1, 2)) == r(1, 24));
    CHECK(cubic(r(2, 3)) == r(16, 81) - r(1, 81));
    CHECK(cubic(0) == 0);
    CHECK(cubic(1) == 1);
}

TEST_CASE(
    "fj-reduction-not-multiaffine: (20) with n = 2 for t^3 is symmetric, has the diagonal, and is cubic in x",
    "[statement]") {
    const Symbol x = Symbol::variable(0);
    const Symbol y = Symbol::variable(1);
    const auto value = [](const Symbol& u, const Symbol& v) {
        return (4 * pow((u + v) * fraction(1, 2), 3) - pow(u, 3) - pow(v, 3)) * fraction(1, 2);
    };
    CHECK(value(x, y) == value(y, x));
    CHECK(value(x, x) == pow(x, 3));
    CHECK(value(x, y).degree_in(0) == 3);
    const auto cube = [](const Rational& t) { return Coordinates{t * t * t}; };
    const std::vector<Parameter> arguments{1, 3};
    CHECK(blossom_from_values(cube, arguments) == Coordinates{2});
    CHECK(value(1, 3) == Symbol(2));
    // So that the reduced curve is not stable under subdivision: over [0, 1/2] it is not the restriction of
    // that over [0, 1].
    const BezierCurve whole = reduce(power_over(3, {}), 2, ReductionMethod::inverse_formula).curve;
    const BezierCurve half = reduce(power_over(3, {0, r(1, 2)}), 2, ReductionMethod::inverse_formula).curve;
    CHECK(control_points(whole, {0, r(1, 2)}) != half);
}

TEST_CASE("fj-nonunique: b[t1,t2] from the values at 0, 1 and 2 is another inverse formula of degree 2",
          "[statement]") {
    Generic g(2);
    const Symbol t1 = g.variables.next();
    const Symbol t2 = g.variables.next();
    const auto lagrange = [&](const Symbols& coefficients) {
        return by_symmetric_functions(coefficients, {t1, t2});
    };
    const Symbol value = lagrange({1, fraction(-3, 2), fraction(1, 2)}) * g.curve(0) +
                         lagrange({0, 2, -1}) * g.curve(1) +
                         lagrange({0, fraction(-1, 2), fraction(1, 2)}) * g.curve(2);
    CHECK(value == g.blossom({t1, t2}));
}
