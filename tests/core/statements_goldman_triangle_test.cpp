// Goldman, Lecture 26, figures 1 to 8: de Casteljau's triangle, blossomed and homogenized. Coefficients,
// arguments and intervals are variables.

#include "support/map_printing.hpp"
#include "support/symbolic.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

/// Every node p(a^(n-r-k), b^k, x_1..x_r) of the triangle is the combination of the two below it.
void check_triangle(GenericPolynomial& curve, const SymbolicArguments& x) {
    const std::size_t n = x.size();
    const Symbol a = curve.variables.next(), b = curve.variables.next();
    const auto node = [&](std::size_t r, std::size_t k) {
        return curve.p(joined({copies(n - r - k, a), copies(k, b),
                               SymbolicArguments(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(r))}));
    };
    for (std::size_t r = 1; r <= n; ++r) {
        for (std::size_t k = 0; k + r <= n; ++k) {
            const auto& [u, mass] = x[r - 1];
            CHECK((b - a) * node(r, k) ==
                  (b * mass - u) * node(r - 1, k) + (u - a * mass) * node(r - 1, k + 1));
        }
    }
}

}  // namespace

TEST_CASE("goldman-mult-notation", "[statement]") {
    for (std::size_t n = 1; n <= 5; ++n) {
        GenericPolynomial curve(n);
        const SymbolicArguments rest = points(curve.variables.next(n - 1));
        const Symbol a = curve.variables.next(), b = curve.variables.next(), u = curve.variables.next();
        CHECK((b - a) * curve.p(joined({rest, {u}})) ==
              (b - u) * curve.p(joined({rest, {a}})) + (u - a) * curve.p(joined({rest, {b}})));
    }
}

TEST_CASE("goldman-fig1-abt", "[statement]") {
    GenericPolynomial curve(3);
    const Symbol a = curve.variables.next(), b = curve.variables.next(), t = curve.variables.next();
    CHECK((b - a) * curve.p({a, b, t}) == (b - t) * curve.p({a, b, a}) + (t - a) * curve.p({a, b, b}));
}

TEST_CASE("goldman-fig1-2", "[statement]") {
    for (std::size_t n = 1; n <= 4; ++n) {
        GenericPolynomial curve(n);
        check_triangle(curve, copies(n, curve.variables.next()));
    }
}

TEST_CASE("goldman-fig3", "[statement]") {
    for (std::size_t n = 1; n <= 4; ++n) {
        GenericPolynomial curve(n);
        check_triangle(curve, points(curve.variables.next(n)));
    }
}

TEST_CASE("goldman-summary-blossoming", "[statement]") {
    // A different argument on every level of the same triangle leads to the blossom at these arguments.
    for (std::size_t n = 1; n <= 6; ++n) {
        GenericBezier curve(n);
        const Symbols u = curve.variables.next(n);
        Symbols row = curve.v;
        for (std::size_t level = 0; level < n; ++level) {
            for (std::size_t k = 0; k + level < n; ++k)
                row[k] = (Symbol(1) - u[level]) * row[k] + u[level] * row[k + 1];
        }
        CHECK(row[0] == curve.q(points(u)));
    }
}

TEST_CASE("goldman-fig6-split", "[statement]") {
    Variables variables;
    const Symbol t = variables.next(), w = variables.next(), a = variables.next(), b = variables.next();
    CHECK((b - a) * t == (b * w - t) * a + (t - a * w) * b);
    CHECK((b - a) * w == (b * w - t) + (t - a * w));
}

TEST_CASE("goldman-fig6", "[statement]") {
    for (std::size_t n = 1; n <= 4; ++n) {
        GenericPolynomial curve(n);
        const SymbolicArgument pair = generic_pairs(curve.variables, 1)[0];
        check_triangle(curve, copies(n, pair));
        CHECK(curve.p(copies(n, pair)) == form_value(curve.c, pair.u, pair.mass));
    }
}

TEST_CASE("goldman-summary-homogenization", "[statement]") {
    // t - a -> t - a w and b - t -> b w - t on every level of [0, 1] make the apex P(t, w).
    for (std::size_t n = 0; n <= 7; ++n) {
        GenericBezier curve(n);
        const Symbol t = curve.variables.next(), w = curve.variables.next();
        CHECK(curve.q(copies(n, {t, w})) == bernstein_value(curve.v, t, w - t));
    }
}

TEST_CASE("goldman-fig7", "[statement]") {
    for (std::size_t n = 1; n <= 4; ++n) {
        GenericPolynomial curve(n);
        check_triangle(curve, generic_pairs(curve.variables, n));
    }
}

TEST_CASE("goldman-fig8", "[statement]") {
    // The apex of the blossomed homogeneous triangle, dehomogenized or put on the diagonal in either order.
    GenericBezier curve(3);
    const SymbolicArguments x = generic_pairs(curve.variables, 3);
    SymbolicArguments affine;
    for (const auto& pair : x) affine.emplace_back(pair.u);
    const Symbol t = curve.variables.next(), w = curve.variables.next();
    CHECK(curve.q(copies(3, {t, w})) == bernstein_value(curve.v, t, w - t));
    CHECK(curve.q(copies(3, t)) == curve(t));
    CHECK(curve.q(affine) == by_casteljau(curve.v, 0, 1, 1, affine));
    CHECK(curve.q(x) == curve.q({x[2], x[0], x[1]}));
}

TEST_CASE("goldman-ex-6", "[statement]") {
    // p(u) = prod (u_k - x) obeys the triangle of figure 3.
    for (std::size_t n = 1; n <= 4; ++n) {
        Variables variables;
        const Symbol x = variables.next(), a = variables.next(), b = variables.next();
        const Symbols u = variables.next(n);
        const auto node = [&](std::size_t r, std::size_t k) {
            Symbol value = pow(a - x, n - r - k) * pow(b - x, k);
            for (std::size_t i = 0; i < r; ++i) value *= u[i] - x;
            return value;
        };
        for (std::size_t r = 1; r <= n; ++r) {
            for (std::size_t k = 0; k + r <= n; ++k) {
                CHECK((b - a) * node(r, k) ==
                      (b - u[r - 1]) * node(r - 1, k) + (u[r - 1] - a) * node(r - 1, k + 1));
            }
        }
    }
}
