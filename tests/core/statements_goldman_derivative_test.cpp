// Goldman, Lecture 26, section 4: derivatives and conversions as blossom values. Coefficients and arguments
// are variables.

#include "support/map_printing.hpp"
#include "support/symbolic.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

/// p(t^(n-k), delta^k).
Symbol derivative_value(const SymbolicBlossom& p, std::size_t k, const Symbol& t) {
    return p(joined({copies(p.degree() - k, t), copies(k, symbolic_delta)}));
}

/// C(n, k) times the k-th difference at the first of n + 1 control points.
Symbols differences(Symbols points) {
    const std::size_t n = points.size() - 1;
    for (std::size_t level = 1; level <= n; ++level) {
        for (std::size_t k = n; k >= level; --k) points[k] -= points[k - 1];
    }
    for (std::size_t k = 0; k <= n; ++k) points[k] = scaled(binomial(n, k), points[k]);
    return points;
}

}  // namespace

TEST_CASE("goldman-thm7", "[statement]") {
    for (std::size_t n = 0; n <= 7; ++n) {
        GenericPolynomial curve(n);
        const Symbol t = curve.variables.next(), h = curve.variables.next();
        Symbols terms;
        for (std::size_t k = 0; k <= n; ++k) {
            terms.push_back(Symbol(Rational(1, factorial(k))) * pow(h, k) *
                            polynomial_value(derivative_coefficients(curve.c, k), t));
        }
        CHECK(curve(t + h) == sum(terms));
    }
}

TEST_CASE("goldman-t-plus-h", "[statement]") {
    for (std::size_t n = 0; n <= 5; ++n) {
        GenericPolynomial curve(n);
        const Symbol t = curve.variables.next(), h = curve.variables.next();
        const SymbolicArgument moved(t + h * symbolic_delta.u, Symbol(1) + h * symbolic_delta.mass);
        CHECK(moved == SymbolicArgument(t + h));
        CHECK(curve.p(copies(n, moved)) == curve(t + h));
    }
}

TEST_CASE("goldman-thm8", "[statement]") {
    // For the multilinear blossom. delta has mass 0: no affine combination of points gives it, which the
    // printed hypothesis of a multiaffine p would need.
    for (std::size_t n = 0; n <= 6; ++n) {
        GenericPolynomial curve(n);
        const Symbol t = curve.variables.next(), h = curve.variables.next();
        Symbols terms;
        for (std::size_t k = 0; k <= n; ++k) {
            terms.push_back(scaled(binomial(n, k), derivative_value(curve.p, k, t)) * pow(h, k));
        }
        CHECK(curve.p(copies(n, {t + h, 1})) == sum(terms));
    }
    CHECK(symbolic_delta.mass.is_zero());
}

TEST_CASE("goldman-thm8-n2", "[statement]") {
    GenericPolynomial curve(2);
    const Symbol t = curve.variables.next(), h = curve.variables.next();
    const SymbolicArgument moved(t + h), part(h, 0);
    CHECK(curve.p({moved, moved}) == curve.p({t, moved}) + curve.p({part, moved}));
    CHECK(curve.p({moved, moved}) == curve.p({t, t}) + scaled(2, curve.p({t, symbolic_delta})) * h +
                                         curve.p({symbolic_delta, symbolic_delta}) * h * h);
}

TEST_CASE("goldman-thm9", "[statement]") {
    // By each construction: symmetric functions and polarization from coefficients, de Casteljau from control
    // points.
    for (std::size_t n = 0; n <= 8; ++n) {
        GenericPolynomial curve(n);
        GenericBezier bezier(n);
        const Symbol t = curve.variables.next();
        const Symbols bezier_coefficients = differences(bezier.v);
        for (std::size_t k = 0; k <= n; ++k) {
            const Integer factor = falling_factorial(n, k);
            const SymbolicArguments arguments = joined({copies(n - k, t), copies(k, symbolic_delta)});
            const Symbol expected = polynomial_value(derivative_coefficients(curve.c, k), t);
            CHECK(scaled(factor, by_symmetric_functions(curve.c, arguments)) == expected);
            CHECK(scaled(factor, by_polarization(curve.c, arguments)) == expected);
            CHECK(scaled(factor, by_casteljau(bezier.v, 0, 1, 1, arguments)) ==
                  polynomial_value(derivative_coefficients(bezier_coefficients, k), t));
        }
    }
}

TEST_CASE("goldman-diff-level", "[statement]") {
    // Any choice of k levels that get the weights -1 and +1 instead of 1 - t and t.
    for (std::size_t n = 1; n <= 5; ++n) {
        GenericBezier curve(n);
        const Symbol t = curve.variables.next();
        const Symbols coefficients = differences(curve.v);
        for (std::size_t levels = 0; levels < std::size_t{1} << n; ++levels) {
            Symbols row = curve.v;
            std::size_t order = 0;
            for (std::size_t level = 0; level < n; ++level) {
                const bool differentiated = (levels >> level & 1) != 0;
                order += differentiated;
                const Symbol left = differentiated ? Symbol(-1) : Symbol(1) - t;
                const Symbol right = differentiated ? Symbol(1) : t;
                for (std::size_t k = 0; k + level < n; ++k) row[k] = left * row[k] + right * row[k + 1];
            }
            CHECK(scaled(falling_factorial(n, order), row[0]) ==
                  polynomial_value(derivative_coefficients(coefficients, order), t));
        }
    }
}

TEST_CASE("goldman-fig9-10", "[statement]") {
    GenericPolynomial cubic(3);
    const Symbol t = cubic.variables.next();
    CHECK(scaled(3, cubic.p({symbolic_delta, t, t})) ==
          polynomial_value(derivative_coefficients(cubic.c, 1), t));
    CHECK(scaled(6, cubic.p({symbolic_delta, symbolic_delta, t})) ==
          polynomial_value(derivative_coefficients(cubic.c, 2), t));
}

TEST_CASE("goldman-summary-diff", "[statement]") {
    // With t - a -> 1 alone the degree 1 triangle gives (b - t) P0 + P1 over b - a; b - t -> -1 is needed
    // beside it.
    GenericBezier line(1);
    const Symbol t = line.variables.next();
    const Symbol derivative = line.v[1] - line.v[0];
    CHECK_FALSE((Symbol(1) - t) * line.v[0] + line.v[1] == derivative);
    CHECK(Symbol(-1) * line.v[0] + line.v[1] == derivative);
}

TEST_CASE("goldman-eq44", "[statement]") {
    for (std::size_t n = 0; n <= 8; ++n) {
        GenericPolynomial curve(n);
        for (std::size_t k = 0; k <= n; ++k) {
            CHECK(scaled(binomial(n, k), derivative_value(curve.p, k, 0)) == curve.c[k]);
        }
    }
}

TEST_CASE("goldman-fig11a", "[statement]") {
    for (std::size_t n = 0; n <= 8; ++n) {
        GenericBezier curve(n);
        const Symbol t = curve.variables.next();
        CHECK(polynomial_value(differences(curve.v), t) == curve(t));
    }
}

TEST_CASE("goldman-fig11b", "[statement]") {
    // P_k = sum_j C(k, j) a_j / C(n, j).
    for (std::size_t n = 0; n <= 8; ++n) {
        GenericPolynomial curve(n);
        const Symbol t = curve.variables.next();
        Symbols control_points;
        for (std::size_t k = 0; k <= n; ++k) {
            Symbols terms;
            for (std::size_t j = 0; j <= k; ++j)
                terms.push_back(Symbol(Rational(binomial(k, j), binomial(n, j))) * curve.c[j]);
            control_points.push_back(sum(terms));
        }
        CHECK(bernstein_value(control_points, t, Symbol(1) - t) == curve(t));
    }
}

TEST_CASE("goldman-fig11-delta", "[statement]") {
    const SymbolicArgument zero(0), one(1);
    CHECK(one.u == zero.u + symbolic_delta.u);
    CHECK(one.mass == zero.mass + symbolic_delta.mass);
}

TEST_CASE("goldman-fig11-nth-derivative", "[statement]") {
    for (std::size_t n = 1; n <= 6; ++n) {
        GenericBezier curve(n);
        const Symbols coefficients = differences(curve.v);
        CHECK(scaled(factorial(n), curve.q(copies(n, symbolic_delta))) ==
              derivative_coefficients(coefficients, n)[0]);
        CHECK(curve.q(copies(n, symbolic_delta)) == coefficients[n]);
    }
}

TEST_CASE("goldman-only-affine", "[statement]") {
    // A value with a delta is a difference of points: it does not see a constant added to P, as a value of
    // points does.
    for (std::size_t n = 1; n <= 5; ++n) {
        GenericPolynomial curve(n);
        const Symbol t = curve.variables.next(), offset = curve.variables.next();
        Symbols moved = curve.c;
        moved[0] += offset;
        const SymbolicArguments with_delta = joined({copies(n - 1, t), {symbolic_delta}});
        CHECK(curve.p(with_delta) ==
              curve.p(joined({copies(n - 1, t), {1}})) - curve.p(joined({copies(n - 1, t), {0}})));
        CHECK(by_symmetric_functions(moved, with_delta) == curve.p(with_delta));
        CHECK(by_symmetric_functions(moved, copies(n, t)) == curve.p(copies(n, t)) + offset);
    }
}

TEST_CASE("goldman-ex-8a", "[statement]") {
    for (std::size_t n = 0; n <= 10; ++n) {
        Variables variables;
        const Symbol a = variables.next(), b = variables.next();
        Symbols terms;
        Symbol repeated = 1;
        for (std::size_t k = 0; k <= n; ++k)
            terms.push_back(scaled(binomial(n, k), pow(a, k) * pow(b, n - k)));
        for (std::size_t k = 0; k < n; ++k) repeated = repeated * (a + b);
        CHECK(repeated == sum(terms));
    }
}

TEST_CASE("goldman-ex-8b", "[statement]") {
    for (std::size_t n = 0; n <= 5; ++n) {
        GenericPolynomial curve(n);
        const Symbol t = curve.variables.next(), h = curve.variables.next();
        Symbols terms;
        for (std::size_t k = 0; k <= n; ++k) {
            terms.push_back(scaled(binomial(n, k), derivative_value(curve.p, k, t)) * pow(h, k));
        }
        CHECK(by_polarization(curve.c, copies(n, {t + h, 1})) == sum(terms));
    }
}

TEST_CASE("goldman-ex-10b", "[statement]") {
    // The coefficients at a are C(n, j) p(a^(n-j), delta^j); in powers of x - a they are P, and at a = 0 they
    // are its own.
    for (std::size_t n = 0; n <= 6; ++n) {
        GenericPolynomial curve(n);
        const Symbol a = curve.variables.next(), x = curve.variables.next();
        Symbols at_a;
        for (std::size_t j = 0; j <= n; ++j)
            at_a.push_back(scaled(binomial(n, j), derivative_value(curve.p, j, a)));
        CHECK(polynomial_value(at_a, x - a) == curve(x));
        Symbols back;
        const SymbolicBlossom local = SymbolicBlossom::of_coefficients(at_a);
        for (std::size_t j = 0; j <= n; ++j)
            back.push_back(scaled(binomial(n, j), derivative_value(local, j, -a)));
        CHECK(back == curve.c);
    }
}

TEST_CASE("goldman-ex-10a", "[statement]") {
    // P_k = sum_j C(k, j) (b - a)^j m_j / C(n, j) for the coefficients m_j in powers of x - a.
    for (std::size_t n = 0; n <= 5; ++n) {
        Variables variables;
        const Symbols m = variables.next(n + 1);
        const Symbol a = variables.next(), b = variables.next(), x = variables.next();
        Symbols control_points;
        for (std::size_t k = 0; k <= n; ++k) {
            Symbols terms;
            for (std::size_t j = 0; j <= k; ++j) {
                terms.push_back(Symbol(Rational(binomial(k, j), binomial(n, j))) * pow(b - a, j) * m[j]);
            }
            control_points.push_back(sum(terms));
        }
        CHECK(bernstein_value(control_points, x - a, b - x) == pow(b - a, n) * polynomial_value(m, x - a));
        const Symbols back = differences(control_points);
        for (std::size_t j = 0; j <= n; ++j) CHECK(back[j] == pow(b - a, j) * m[j]);
    }
}

TEST_CASE("goldman-ex-10c", "[statement]") {
    for (std::size_t n = 0; n <= 4; ++n) {
        GenericPolynomial curve(n);
        const Symbol a = curve.variables.next(), b = curve.variables.next(), x = curve.variables.next();
        Symbols control_points;
        for (std::size_t k = 0; k <= n; ++k)
            control_points.push_back(curve.p(joined({copies(n - k, a), copies(k, b)})));
        CHECK(bernstein_value(control_points, x - a, b - x) == pow(b - a, n) * curve(x));
        // And back: sum_k D_k (x - a)^k (b - a)^(n-k) has the coefficients (b - a)^n c_k.
        const Symbols steps = differences(control_points);
        Symbols terms;
        for (std::size_t k = 0; k <= n; ++k) terms.push_back(steps[k] * pow(x - a, k) * pow(b - a, n - k));
        CHECK(sum(terms) == pow(b - a, n) * curve(x));
    }
}

TEST_CASE("goldman-ex-3", "[statement]") {
    // The blossom of (t - t_k)^n at the other nodes is prod (t_i - t_k) in slot k, and 0 in every other slot.
    for (std::size_t n = 1; n <= 4; ++n) {
        Variables variables;
        const Symbols nodes = variables.next(n + 1);
        for (std::size_t k = 0; k <= n; ++k) {
            Symbols coefficients;
            for (std::size_t j = 0; j <= n; ++j)
                coefficients.push_back(scaled(binomial(n, j), pow(-nodes[k], n - j)));
            Symbol expected = 1;
            for (std::size_t i = 0; i <= n; ++i) {
                if (i != k) expected *= nodes[i] - nodes[k];
            }
            for (std::size_t slot = 0; slot <= n; ++slot) {
                const Symbol value = by_symmetric_functions(coefficients, without(points(nodes), slot));
                CHECK(value == (slot == k ? expected : Symbol(0)));
            }
        }
    }
}

TEST_CASE("goldman-fig12-15", "[statement]") {
    // Every node of the cubic triangle with t on some levels and delta on the others is the blossom value it
    // is labelled with.
    for (std::size_t levels = 0; levels < 8; ++levels) {
        GenericBezier curve(3);
        const Symbol t = curve.variables.next();
        Symbols row = curve.v;
        SymbolicArguments used;
        for (std::size_t level = 0; level < 3; ++level) {
            const SymbolicArgument argument =
                (levels >> level & 1) != 0 ? symbolic_delta : SymbolicArgument(t);
            used.push_back(argument);
            for (std::size_t k = 0; k + level < 3; ++k) {
                row[k] = (argument.mass - argument.u) * row[k] + argument.u * row[k + 1];
                CHECK(row[k] == curve.q(joined({used, copies(2 - level - k, 0), copies(k, 1)})));
            }
        }
    }
}
