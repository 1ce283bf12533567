// Goldman, Lecture 26, section 4.1: homogenization. Coefficients, arguments and masses are variables.

#include "support/map_printing.hpp"
#include "support/symbolic.hpp"

using namespace blossom;
using namespace blossom::testing;

TEST_CASE("goldman-monomial-scale", "[statement]") {
    // P(ct) - c^n P(t) vanishes exactly when a_0 = ... = a_(n-1) = 0; so the printed inequality needs that
    // exception.
    for (std::size_t n = 1; n <= 5; ++n) {
        GenericPolynomial curve(n);
        const Symbol c = curve.variables.next(), t = curve.variables.next();
        const auto defect = [&](const Symbols& a) {
            return polynomial_value(a, c * t) - pow(c, n) * polynomial_value(a, t);
        };
        CHECK(rank_of_conditions({defect(curve.c)}, n + 1) == n);
        Symbols monomial(n + 1);
        monomial[n] = curve.c[n];
        CHECK(defect(monomial).is_zero());
        CHECK((n == 1) == (polynomial_value(monomial, c * t) == c * polynomial_value(monomial, t)));
    }
}

TEST_CASE("goldman-homogenize", "[statement]") {
    for (std::size_t n = 0; n <= 7; ++n) {
        GenericPolynomial curve(n);
        const Symbol c = curve.variables.next(), t = curve.variables.next(), w = curve.variables.next();
        CHECK(form_value(curve.c, c * t, c * w) == pow(c, n) * form_value(curve.c, t, w));
        CHECK(form_value(curve.c, t, 1) == curve(t));
    }
}

TEST_CASE("goldman-hblossom-terms", "[statement]") {
    for (std::size_t n = 1; n <= 5; ++n) {
        GenericPolynomial curve(n);
        const Symbol value = curve.p(generic_pairs(curve.variables, n));
        for (std::size_t term = 0; term < value.size(); ++term) {
            for (std::size_t k = 0; k < n; ++k) {
                CHECK(value.exponent(term, n + 1 + 2 * k) + value.exponent(term, n + 2 + 2 * k) == 1);
            }
        }
    }
}

TEST_CASE("goldman-hblossom-scale", "[statement]") {
    for (std::size_t n = 1; n <= 5; ++n) {
        GenericPolynomial curve(n);
        const SymbolicArguments x = generic_pairs(curve.variables, n);
        const Symbol c = curve.variables.next();
        for (std::size_t k = 0; k < n; ++k) {
            CHECK(curve.p(replaced(x, k, {c * x[k].u, c * x[k].mass})) == c * curve.p(x));
        }
    }
}

TEST_CASE("goldman-hblossom-dehom", "[statement]") {
    // At masses 1 the homogeneous blossom is the sum over subsets of the definition.
    for (std::size_t n = 0; n <= 6; ++n) {
        GenericPolynomial curve(n);
        const Symbols u = curve.variables.next(n);
        Symbols terms;
        for (std::size_t k = 0; k <= n; ++k) terms.push_back(curve.c[k] * subset_average(u, k));
        CHECK(curve.p(points(u)) == sum(terms));
    }
}

TEST_CASE("goldman-haxioms", "[statement]") {
    for (std::size_t n = 1; n <= 4; ++n) {
        GenericPolynomial curve(n);
        const SymbolicArguments x = generic_pairs(curve.variables, n);
        const SymbolicArgument y = generic_pairs(curve.variables, 1)[0];
        const Symbol c = curve.variables.next();
        for (std::size_t k = 0; k < n; ++k) {
            CHECK(curve.p(replaced(x, k, {x[k].u + y.u, x[k].mass + y.mass})) ==
                  curve.p(x) + curve.p(replaced(x, k, y)));
            CHECK(curve.p(replaced(x, k, {c * x[k].u, c * x[k].mass})) == c * curve.p(x));
            SymbolicArguments swapped = x;
            std::swap(swapped[0], swapped[k]);
            CHECK(curve.p(swapped) == curve.p(x));
        }
        CHECK(curve.p(copies(n, y)) == form_value(curve.c, y.u, y.mass));
    }
}

TEST_CASE("goldman-fig4", "[statement]") {
    // Also by polarization and by de Casteljau, each from its own source.
    Variables variables;
    const SymbolicArguments x = generic_pairs(variables, 3);
    const Symbol u1 = x[0].u, u2 = x[1].u, u3 = x[2].u;
    const Symbol v1 = x[0].mass, v2 = x[1].mass, v3 = x[2].mass;
    const Symbol third(Rational(1, 3));
    struct Row {
        Symbols coefficients;
        Symbols control_points;
        Symbol blossom;
    };
    const Row rows[] = {
        {{1, 0, 0, 0}, {1, 1, 1, 1}, v1 * v2 * v3},
        {{0, 1, 0, 0}, {0, third, third + third, 1}, third * (u1 * v2 * v3 + u2 * v3 * v1 + u3 * v1 * v2)},
        {{0, 0, 1, 0}, {0, 0, third, 1}, third * (u1 * u2 * v3 + u2 * u3 * v1 + u3 * u1 * v2)},
        {{0, 0, 0, 1}, {0, 0, 0, 1}, u1 * u2 * u3},
    };
    for (const Row& row : rows) {
        CHECK(by_symmetric_functions(row.coefficients, x) == row.blossom);
        CHECK(by_polarization(row.coefficients, x) == row.blossom);
        CHECK(by_casteljau(row.control_points, 0, 1, 1, x) == row.blossom);
    }
}

TEST_CASE("goldman-thm6", "[statement]") {
    // Homogenizing the affine blossom: each monomial c_k prod_{S} u_i becomes c_k prod_{S} u_i prod_{not S}
    // v_i.
    for (std::size_t n = 1; n <= 6; ++n) {
        GenericPolynomial curve(n);
        const SymbolicArguments x = generic_pairs(curve.variables, n);
        SymbolicArguments affine;
        for (const auto& pair : x) affine.emplace_back(pair.u);
        const Symbol value = curve.p(affine);
        Symbols terms;
        for (std::size_t term = 0; term < value.size(); ++term) {
            Symbol homogenized = Symbol(value.coefficient(term));
            for (std::size_t k = 0; k <= n; ++k) homogenized *= pow(curve.c[k], value.exponent(term, k));
            for (std::size_t i = 0; i < n; ++i) {
                homogenized *= value.exponent(term, n + 1 + 2 * i) == 1 ? x[i].u : x[i].mass;
            }
            terms.push_back(homogenized);
        }
        CHECK(sum(terms) == curve.p(x));
    }
}

TEST_CASE("goldman-ex-7b", "[statement]") {
    // w^n P(t / w, 1) with t = w x.
    for (std::size_t n = 0; n <= 6; ++n) {
        GenericPolynomial curve(n);
        const Symbol x = curve.variables.next(), w = curve.variables.next();
        CHECK(form_value(curve.c, w * x, w) == pow(w, n) * curve(x));
    }
}

TEST_CASE("goldman-ex-7a", "[statement]") {
    // Cross-multiplied: P(ct, cw) Q(t, w) = P(t, w) Q(ct, cw).
    for (std::size_t n = 0; n <= 4; ++n) {
        GenericPolynomial p(n);
        const Symbols d = p.variables.next(n + 1);
        const Symbol c = p.variables.next(), t = p.variables.next(), w = p.variables.next();
        CHECK(form_value(p.c, c * t, c * w) * form_value(d, t, w) ==
              form_value(p.c, t, w) * form_value(d, c * t, c * w));
    }
}
