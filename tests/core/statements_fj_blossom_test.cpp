// Fernandez-Jambrina: Inverse Relations for Blossoms and Parametrisations of Rational Curves and Surfaces
// (2024), section 2.
//
// Control points, coefficients and arguments are symbols: each case decides its statement for all of them, at
// the degrees that it names.

#include <blossom/core/blossom/change_of_basis.hpp>
#include <blossom/core/curve/derivative.hpp>
#include <blossom/rational/combinatorics.hpp>

#include <algorithm>

#include "support/map_generators.hpp"
#include "support/map_printing.hpp"
#include "support/symbolic_curves.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

/// Generic vertices b_0..b_n and the blossom from the monomial coefficients of their curve, by symmetric
/// functions.
struct Generic {
    Variables variables;
    Symbols b;
    Symbols c;
    SymbolicBlossom blossom;
    Symbol t;

    explicit Generic(std::size_t n)
        : b(variables.next(n + 1)),
          c(constructions::local_monomial_from_bernstein(std::span<const Symbol>(b))),
          blossom(SymbolicBlossom::of_coefficients(c)),
          t(variables.next()) {}

    Symbol curve(const Symbol& parameter) const { return bezier_value(b, 0, 1, parameter); }
};

/// B_i^n with the exponents as printed, (1-t)^i t^(n-i).
Symbol printed_bernstein(std::size_t n, std::size_t i, const Symbol& t) {
    return scaled(binomial(n, i), pow(1 - t, i) * pow(t, n - i));
}

/// Two vectors of R^3, their sum and their difference.
struct Space {
    Symbols v;
    Symbols w;
    Symbols sum;
    Symbols difference;

    Space() {
        Variables variables;
        v = variables.next(3);
        w = variables.next(3);
        for (std::size_t i = 0; i < 3; ++i) {
            sum.push_back(v[i] + w[i]);
            difference.push_back(v[i] - w[i]);
        }
    }

    static Symbol product(const Symbols& x, const Symbols& y) {
        return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
    }
    static Symbol squared_norm(const Symbols& x) { return pow(x[0], 2) + pow(x[1], 2) + pow(x[2], 2); }
};

}  // namespace

TEST_CASE("fj-bezier-def: b(t) = sum b_i B_i^n(t) is the curve that the engine has, n = 0..8",
          "[statement]") {
    for (std::size_t n = 0; n <= 8; ++n) {
        const Generic g(n);
        Symbols terms;
        for (std::size_t i = 0; i <= n; ++i) {
            terms.push_back(scaled(binomial(n, i), g.b[i] * pow(g.t, i) * pow(1 - g.t, n - i)));
        }
        CHECK(sum(terms) == polynomial_value(g.c, g.t));
        CHECK(sum(terms) == by_casteljau(g.b, 0, 1, 1, copies(n, g.t)));
    }
}

TEST_CASE(
    "fj-bernstein-def: printed with exponents exchanged, which is B_(n-i) and contradicts Eq.(1); n = 1..6",
    "[statement]") {
    for (std::size_t n = 1; n <= 6; ++n) {
        const Generic g(n);
        Symbol printed;
        for (std::size_t i = 0; i <= n; ++i) {
            CHECK(printed_bernstein(n, i, g.t) == scaled(binomial(n, i), pow(g.t, n - i) * pow(1 - g.t, i)));
            printed += g.b[i] * printed_bernstein(n, i, g.t);
        }
        const Symbol casteljau = symbolic_pyramid(g.b, 0, 1, copies(n, g.t)).back().front();
        CHECK(printed != casteljau);
        CHECK(g.curve(g.t) == casteljau);
        Symbols reversed = g.b;
        std::ranges::reverse(reversed);
        CHECK(printed == bezier_value(reversed, 0, 1, g.t));
    }
    CHECK(printed_bernstein(1, 0, Symbol::variable(0)) == Symbol::variable(0));
}

TEST_CASE("fj-eq1: the recursion with one parameter gives b(t), n = 1..7", "[statement]") {
    for (std::size_t n = 1; n <= 7; ++n) {
        const Generic g(n);
        Symbols level = g.b;
        for (std::size_t r = 1; r <= n; ++r) {
            for (std::size_t i = 0; i <= n - r; ++i) level[i] = (1 - g.t) * level[i] + g.t * level[i + 1];
        }
        CHECK(level.front() == polynomial_value(g.c, g.t));
    }
}

TEST_CASE("fj-eq2: the recursion with t_1..t_n gives the blossom, n = 1..5", "[statement]") {
    for (std::size_t n = 1; n <= 5; ++n) {
        Generic g(n);
        const Symbols t = g.variables.next(n);
        Symbols level = g.b;
        for (std::size_t r = 1; r <= n; ++r) {
            for (std::size_t i = 0; i <= n - r; ++i)
                level[i] = (1 - t[r - 1]) * level[i] + t[r - 1] * level[i + 1];
        }
        CHECK(level.front() == g.blossom(points(t)));
    }
}

TEST_CASE("fj-corners: b_i is the value at n-i zeros and i ones, n = 0..8", "[statement]") {
    for (std::size_t n = 0; n <= 8; ++n) {
        const Generic g(n);
        CHECK(end_values(g.blossom, 0, 1) == g.b);
    }
}

TEST_CASE("fj-n2-explicit: (1-t1)(1-t2) b0 + (t1(1-t2) + t2(1-t1)) b1 + t1 t2 b2, symmetric", "[statement]") {
    Generic g(2);
    const Symbol t1 = g.variables.next();
    const Symbol t2 = g.variables.next();
    CHECK(g.blossom({t1, t2}) ==
          (1 - t1) * (1 - t2) * g.b[0] + (t1 * (1 - t2) + t2 * (1 - t1)) * g.b[1] + t1 * t2 * g.b[2]);
    CHECK(g.blossom({t1, t2}) == g.blossom({t2, t1}));
}

TEST_CASE("fj-n3-pyramid: the levels of degree three have 4, 3, 2, 1 entries b_i^r[t1..tr]", "[statement]") {
    Generic g(3);
    const Symbols t = g.variables.next(3);
    const auto levels = symbolic_pyramid(g.b, 0, 1, points(t));
    REQUIRE(levels.size() == 4);
    for (std::size_t r = 0; r <= 3; ++r) {
        REQUIRE(levels[r].size() == 4 - r);
        const SymbolicArguments used(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(r));
        for (std::size_t i = 0; i + r <= 3; ++i) {
            CHECK(levels[r][i] == g.blossom(joined({runs(3 - r - i, 0, i, 1), used})));
        }
    }
}

TEST_CASE("fj-diagonal: b[t..t] = b(t), n = 0..7; off the diagonal a value may lie on the curve all the same",
          "[statement]") {
    for (std::size_t n = 0; n <= 7; ++n) {
        const Generic g(n);
        CHECK(g.blossom(copies(n, g.t)) == g.curve(g.t));
    }
    // The line b(t) = t of formal degree 2: b[t1, t2] = b((t1 + t2) / 2) with t1 != t2.
    const Symbol t1 = Symbol::variable(0);
    const Symbol t2 = Symbol::variable(1);
    CHECK(by_symmetric_functions({0, 1, 0}, {t1, t2}) == (t1 + t2) * fraction(1, 2));
    // In general it does not: b[0, 1] = (1/2, 0) is no point of the parabola (t, t^2).
    CHECK(by_symmetric_functions({0, 1, 0}, {0, 1}) == fraction(1, 2));
    CHECK(by_symmetric_functions({0, 0, 1}, {0, 1}) != fraction(1, 4));
}

TEST_CASE("fj-symmetric: the pyramid does not depend on the order, n = 2..5, adjacent transpositions",
          "[statement]") {
    for (std::size_t n = 2; n <= 5; ++n) {
        Generic g(n);
        const Symbols t = g.variables.next(n);
        for (std::size_t i = 0; i + 1 < n; ++i) {
            Symbols exchanged = t;
            std::swap(exchanged[i], exchanged[i + 1]);
            CHECK(by_casteljau(g.b, 0, 1, 1, points(exchanged)) == by_casteljau(g.b, 0, 1, 1, points(t)));
        }
    }
}

TEST_CASE("fj-eq3: b[.., l t_i + m s_i, ..] is affine in every slot for l + m = 1, n = 1..5", "[statement]") {
    for (std::size_t n = 1; n <= 5; ++n) {
        Generic g(n);
        const SymbolicArguments t = points(g.variables.next(n));
        const Symbol s = g.variables.next();
        const Symbol m = g.variables.next();
        for (std::size_t i = 0; i < n; ++i) {
            CHECK(g.blossom(replaced(t, i, (1 - m) * t[i].u + m * s)) ==
                  (1 - m) * g.blossom(t) + m * g.blossom(replaced(t, i, s)));
        }
    }
}

TEST_CASE("fj-eq4-missing: reconstructed, the vertices on [alpha,beta] are b[alpha^(n-i),beta^i], n = 0..5",
          "[statement]") {
    for (std::size_t n = 0; n <= 5; ++n) {
        Generic g(n);
        const Symbol alpha = g.variables.next();
        const Symbol beta = g.variables.next();
        CHECK(bezier_value(end_values(g.blossom, alpha, beta), alpha, beta, g.t) ==
              pow(beta - alpha, n) * g.curve(g.t));
    }
}

TEST_CASE("fj-eq10: the r-th derivative at 0 is n!/(n-r)! times the r-th difference of b_0, n = 0..7",
          "[statement]") {
    for (std::size_t n = 0; n <= 7; ++n) {
        const Generic g(n);
        Symbols differences = g.b;
        for (std::size_t r = 0; r <= n; ++r) {
            CHECK(polynomial_value(derivative_coefficients(g.c, r), 0) ==
                  scaled(falling_factorial(n, r), differences.front()));
            for (std::size_t i = 0; i + 1 < differences.size(); ++i)
                differences[i] = differences[i + 1] - differences[i];
            differences.pop_back();
        }
    }
}

TEST_CASE("fj-derivation: derivation is an algebraic operation here, exact by Eq.(10) on random curves",
          "[statement]") {
    Random random(391);
    for (std::size_t i = 0; i < 90; ++i) {
        const std::size_t n = i % 9;
        BezierRecipe recipe = bezier_map(random, n, Size::any);
        const BezierCurve curve(recipe.control_points);
        std::vector<Coordinates> differences = recipe.control_points;
        for (std::size_t r = 0; r <= n; ++r) {
            Coordinates expected = differences.front();
            for (Rational& coordinate : expected) coordinate *= falling_factorial(n, r);
            CHECK(derivative(curve, r, 0) == expected);
            for (std::size_t k = 0; k + 1 < differences.size(); ++k) {
                for (std::size_t j = 0; j < expected.size(); ++j)
                    differences[k][j] = differences[k + 1][j] - differences[k][j];
            }
            differences.pop_back();
        }
    }
}

TEST_CASE("fj-eq11: |v|^2 = <v,v> in R^3", "[statement]") {
    const Space space;
    CHECK(Space::squared_norm(space.v) == Space::product(space.v, space.v));
}

TEST_CASE("fj-eq12: 2 <v,w> = |v+w|^2 - |v|^2 - |w|^2 in R^3", "[statement]") {
    const Space space;
    CHECK(2 * Space::product(space.v, space.w) ==
          Space::squared_norm(space.sum) - Space::squared_norm(space.v) - Space::squared_norm(space.w));
}

TEST_CASE("fj-eq13: 4 <v,w> = |v+w|^2 - |v-w|^2 in R^3", "[statement]") {
    const Space space;
    CHECK(4 * Space::product(space.v, space.w) ==
          Space::squared_norm(space.sum) - Space::squared_norm(space.difference));
}
