// DeRose, Goldman, Lounsbery, section 3 and figure 6: the blossom of a polynomial. Coefficients and arguments
// are variables.

#include <algorithm>
#include <vector>

#include "support/map_printing.hpp"
#include "support/symbolic.hpp"

using namespace blossom;
using namespace blossom::testing;

TEST_CASE("derose-ex-1-2-4-1", "[statement]") {
    Variables variables;
    const Symbols u = variables.next(3);
    const Symbol expected = Symbol(1) + Symbol(Rational(2, 3)) * (u[0] + u[1] + u[2]) +
                            Symbol(Rational(4, 3)) * (u[0] * u[1] + u[0] * u[2] + u[1] * u[2]) -
                            u[0] * u[1] * u[2];
    CHECK(by_symmetric_functions({1, 2, 4, -1}, points(u)) == expected);
    CHECK(by_polarization({1, 2, 4, -1}, points(u)) == expected);
    const Symbols control_points{1, Symbol(Rational(5, 3)), Symbol(Rational(11, 3)), 6};
    CHECK(by_casteljau(control_points, 0, 1, 1, points(u)) == expected);
}

TEST_CASE("derose-eq2", "[statement]") {
    // Over subsets i1 < .. < ik the equation holds. Over ordered choices of distinct indices, as it reads,
    // every product comes k! times: wrong for k >= 2, for instance u1 u2 + u2 u1 = 2 u1 u2 at D = k = 2.
    for (std::size_t degree = 0; degree <= 6; ++degree) {
        for (std::size_t k = 0; k <= degree; ++k) {
            Variables variables;
            const Symbols u = variables.next(degree);
            Symbols monomial(degree + 1);
            monomial[k] = 1;
            const Symbol blossom = by_symmetric_functions(monomial, points(u));
            CHECK(blossom == subset_average(u, k));

            // The ordered sum, one index after the other.
            Symbols partial{1};
            std::vector<std::vector<std::size_t>> chosen{{}};
            for (std::size_t step = 0; step < k; ++step) {
                Symbols longer;
                std::vector<std::vector<std::size_t>> choices;
                for (std::size_t i = 0; i < partial.size(); ++i) {
                    for (std::size_t index = 0; index < degree; ++index) {
                        if (std::ranges::find(chosen[i], index) != chosen[i].end()) continue;
                        longer.push_back(partial[i] * u[index]);
                        choices.push_back(chosen[i]);
                        choices.back().push_back(index);
                    }
                }
                partial = std::move(longer);
                chosen = std::move(choices);
            }
            const Symbol literal = sum(partial) * Symbol(Rational(1, binomial(degree, k)));
            CHECK((literal == blossom) == (k < 2));
            CHECK(literal == scaled(factorial(k), blossom));
        }
    }
}

TEST_CASE("derose-eq3", "[statement]") {
    for (std::size_t degree = 0; degree <= 7; ++degree) {
        GenericPolynomial curve(degree);
        const Symbols u = curve.variables.next(degree);
        Symbols terms;
        for (std::size_t k = 0; k <= degree; ++k) terms.push_back(curve.c[k] * subset_average(u, k));
        CHECK(curve.p(points(u)) == sum(terms));
    }
}

TEST_CASE("derose-linearity", "[statement]") {
    for (std::size_t degree = 1; degree <= 5; ++degree) {
        Variables variables;
        const Symbols c = variables.next(degree + 1), d = variables.next(degree + 1);
        const Symbol a = variables.next(), b = variables.next();
        const SymbolicArguments u = points(variables.next(degree));
        Symbols combined;
        for (std::size_t k = 0; k <= degree; ++k) combined.push_back(a * c[k] + b * d[k]);
        CHECK(by_symmetric_functions(combined, u) ==
              a * by_symmetric_functions(c, u) + b * by_symmetric_functions(d, u));
    }
}

TEST_CASE("derose-thm1-exist", "[statement]") {
    // Lower degrees d <= D are leading coefficients 0.
    for (std::size_t degree = 1; degree <= 5; ++degree) {
        GenericPolynomial curve(degree);
        const SymbolicArguments u = points(curve.variables.next(degree));
        const Symbol t = curve.variables.next(), a = curve.variables.next(), v = curve.variables.next();
        CHECK(curve.p(copies(degree, t)) == curve(t));
        for (std::size_t i = 0; i < degree; ++i) {
            SymbolicArguments swapped = u;
            std::swap(swapped[0], swapped[i]);
            CHECK(curve.p(swapped) == curve.p(u));
            CHECK(curve.p(replaced(u, i, a * u[i].u + (Symbol(1) - a) * v)) ==
                  a * curve.p(u) + (Symbol(1) - a) * curve.p(replaced(u, i, v)));
        }
    }
}

TEST_CASE("derose-u2-candidate", "[statement]") {
    // q = u1 u2 for u^2 with D = 3: affine in each argument, right on the diagonal, and not symmetric.
    Variables variables;
    const Symbols u = variables.next(3);
    const Symbol a = variables.next(), v = variables.next();
    const auto q = [](const Symbol& x, const Symbol& y, const Symbol&) { return x * y; };
    CHECK(q(a * u[0] + (Symbol(1) - a) * v, u[1], u[2]) ==
          a * q(u[0], u[1], u[2]) + (Symbol(1) - a) * q(v, u[1], u[2]));
    CHECK(q(v, v, v) == v * v);
    CHECK_FALSE(q(u[0], u[1], u[2]) == q(u[2], u[1], u[0]));
    CHECK_FALSE(q(u[0], u[1], u[2]) == by_symmetric_functions({0, 0, 1, 0}, points(u)));
}

TEST_CASE("derose-blossom3-u2", "[statement]") {
    Variables variables;
    const Symbols u = variables.next(3);
    CHECK(by_symmetric_functions({0, 0, 1, 0}, points(u)) ==
          Symbol(Rational(1, 3)) * (u[0] * u[1] + u[1] * u[2] + u[0] * u[2]));
}

TEST_CASE("derose-fig6", "[statement]") {
    // The program of the figure, line by line, and the kernel, against the sum over subsets of control
    // points.
    for (std::size_t degree = 0; degree <= 6; ++degree) {
        GenericBezier curve(degree);
        const Symbols u = curve.variables.next(degree);
        Symbols v = curve.v;
        for (std::size_t i = 1; i <= degree; ++i) {
            for (std::size_t j = 0; j <= degree - i; ++j)
                v[j] = (Symbol(1) - u[i - 1]) * v[j] + u[i - 1] * v[j + 1];
        }
        Symbols terms;
        for (std::size_t subset = 0; subset < std::size_t{1} << degree; ++subset) {
            std::size_t k = 0;
            Symbol term = 1;
            for (std::size_t i = 0; i < degree; ++i) {
                const bool inside = (subset >> i & 1) != 0;
                k += inside;
                term *= inside ? u[i] : Symbol(1) - u[i];
            }
            terms.push_back(curve.v[k] * term);
        }
        CHECK(v[0] == sum(terms));
        CHECK(by_casteljau(curve.v, 0, 1, 1, points(u)) == sum(terms));
    }
}
