// Goldman, Lecture 26, section 3: control points as blossom values. Coefficients and intervals are variables.

#include "support/map_printing.hpp"
#include "support/symbolic.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

/// p(a^(n-k), b^k) for k = 0..n.
Symbols dual_values(const SymbolicBlossom& p, const Symbol& a, const Symbol& b) {
    Symbols values;
    for (std::size_t k = 0; k <= p.degree(); ++k)
        values.push_back(p(joined({copies(p.degree() - k, a), copies(k, b)})));
    return values;
}

}  // namespace

TEST_CASE("goldman-dual-functional", "[statement]") {
    for (std::size_t n = 1; n <= 6; ++n) {
        GenericPolynomial curve(n);
        const Symbol a = curve.variables.next(), b = curve.variables.next(), t = curve.variables.next();
        CHECK(bernstein_value(dual_values(curve.p, a, b), t - a, b - t) == pow(b - a, n) * curve(t));
    }
}

TEST_CASE("goldman-thm3", "[statement]") {
    // The values p(a^(n-k), b^k) are control points over every [a, b].
    for (std::size_t n = 1; n <= 5; ++n) {
        GenericPolynomial curve(n);
        const Symbol a = curve.variables.next(), b = curve.variables.next(), t = curve.variables.next();
        CHECK(bernstein_value(dual_values(curve.p, a, b), t - a, b - t) == pow(b - a, n) * curve(t));
    }
}

TEST_CASE("goldman-thm4", "[statement]") {
    // From control points that are variables: the blossom gives them back, over [0, 1] and over [-2/3, 5/7].
    for (std::size_t n = 1; n <= 7; ++n) {
        GenericBezier curve(n);
        for (std::size_t k = 0; k <= n; ++k) {
            CHECK(curve.q(joined({copies(n - k, 0), copies(k, 1)})) == curve.v[k]);
            const Symbol a(Rational(-2, 3)), b(Rational(5, 7));
            CHECK(by_casteljau(curve.v, -14, 15, 21, joined({copies(n - k, a), copies(k, b)})) == curve.v[k]);
        }
    }
}

TEST_CASE("goldman-subdivision", "[statement]") {
    for (std::size_t n = 1; n <= 4; ++n) {
        GenericPolynomial curve(n);
        const Symbol a = curve.variables.next(), b = curve.variables.next();
        const Symbol t = curve.variables.next(), x = curve.variables.next();
        CHECK(bernstein_value(dual_values(curve.p, a, t), x - a, t - x) == pow(t - a, n) * curve(x));
        CHECK(bernstein_value(dual_values(curve.p, t, b), x - t, b - x) == pow(b - t, n) * curve(x));
    }
}

TEST_CASE("goldman-ex-9", "[statement]") {
    // The control points of t as a polynomial of degree n are a + k (b - a) / n.
    for (std::size_t n = 1; n <= 6; ++n) {
        Variables variables;
        const Symbol a = variables.next(), b = variables.next();
        Symbols identity(n + 1);
        identity[1] = 1;
        const Symbols values = dual_values(SymbolicBlossom::of_coefficients(identity), a, b);
        for (std::size_t k = 0; k <= n; ++k) CHECK(values[k] == a + Symbol(Rational(k, n)) * (b - a));
    }
}

TEST_CASE("goldman-ex-12a", "[statement]") {
    // The sum runs over all n + 1 arguments; up to n, as printed, P = 1 gives n / (n + 1).
    for (std::size_t n = 0; n <= 5; ++n) {
        GenericPolynomial curve(n);
        Symbols raised = curve.c;
        raised.emplace_back(0);
        const SymbolicArguments u = points(curve.variables.next(n + 1));
        Symbols omitted;
        for (std::size_t k = 0; k <= n; ++k) omitted.push_back(curve.p(without(u, k)));
        const Symbol share(Rational(1, n + 1));
        CHECK(by_symmetric_functions(raised, u) == share * sum(omitted));
        const Symbol printed = share * sum(std::span(omitted).first(n));
        CHECK_FALSE(by_symmetric_functions(raised, u) == printed);
        if (n > 0) continue;
        CHECK(printed.is_zero());
    }
    Symbols one{1, 0, 0};
    const Symbol printed =
        Symbol(Rational(1, 3)) * (by_symmetric_functions(one, {1, 2}) + by_symmetric_functions(one, {0, 2}));
    CHECK(printed == Symbol(Rational(2, 3)));
}

TEST_CASE("goldman-ex-12b", "[statement]") {
    for (std::size_t n = 0; n <= 5; ++n) {
        GenericPolynomial curve(n);
        Symbols raised = curve.c;
        raised.emplace_back(0);
        const Symbol a = curve.variables.next(), b = curve.variables.next();
        const Symbols lower = dual_values(curve.p, a, b);
        const Symbols upper = dual_values(SymbolicBlossom::of_coefficients(raised), a, b);
        for (std::size_t k = 0; k <= n + 1; ++k) {
            const Symbol left = k == 0 ? Symbol(0) : Symbol(Rational(k, n + 1)) * lower[k - 1];
            const Symbol right = k > n ? Symbol(0) : Symbol(Rational(n + 1 - k, n + 1)) * lower[k];
            CHECK(upper[k] == left + right);
        }
    }
}
