// DeRose, Goldman, Lounsbery: A Tutorial Introduction to Blossoming (1991), section 3: the quadratic Bezier
// curve and its blossom.
//
// Control points and arguments are symbols: each case decides its statement for all of them.

#include "support/map_printing.hpp"
#include "support/symbolic_curves.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

/// Generic control points v_0, v_1, v_2 and parameters.
struct Quadratic {
    Variables variables;
    Symbols v = variables.next(3);
    Symbol u = variables.next();
    Symbol u1 = variables.next();
    Symbol u2 = variables.next();

    /// Q(u) as the sum of v_i B_i^2(u).
    Symbol curve(const Symbol& at) const {
        return v[0] * pow(1 - at, 2) + v[1] * (2 * at * (1 - at)) + v[2] * pow(at, 2);
    }
    /// The blossom by de Casteljau's algorithm.
    Symbol q(const Symbol& x, const Symbol& y) const { return by_casteljau(v, 0, 1, 1, {x, y}); }
    Symbol printed_q(const Symbol& x, const Symbol& y) const {
        return v[0] * (1 - x) * (1 - y) + v[1] * (x * (1 - y) + y * (1 - x)) + v[2] * x * y;
    }
};

}  // namespace

TEST_CASE("derose-quad-bezier: Q(u) is the sum of v_i C(2,i) u^i (1-u)^(2-i)", "[statement]") {
    const Quadratic g;
    CHECK(bezier_value(g.v, 0, 1, g.u) == g.curve(g.u));
    CHECK(by_casteljau(g.v, 0, 1, 1, {g.u, g.u}) == g.curve(g.u));
}

TEST_CASE("derose-dcj-quad: two levels of linear interpolation give Q(u)", "[statement]") {
    const Quadratic g;
    const Symbol v01 = (1 - g.u) * g.v[0] + g.u * g.v[1];
    const Symbol v11 = (1 - g.u) * g.v[1] + g.u * g.v[2];
    CHECK((1 - g.u) * v01 + g.u * v11 == g.curve(g.u));
    CHECK(symbolic_pyramid(g.v, 0, 1, copies(2, g.u))[1] == Symbols{v01, v11});
}

TEST_CASE("derose-q-def: the printed q(u1,u2) is the blossom of Q", "[statement]") {
    const Quadratic g;
    const Symbols coefficients{g.v[0], 2 * (g.v[1] - g.v[0]), g.v[0] - 2 * g.v[1] + g.v[2]};
    REQUIRE(polynomial_value(coefficients, g.u) == g.curve(g.u));
    CHECK(by_symmetric_functions(coefficients, {g.u1, g.u2}) == g.printed_q(g.u1, g.u2));
    CHECK(g.q(g.u1, g.u2) == g.printed_q(g.u1, g.u2));
}

TEST_CASE("derose-q-prop1: q(u1,u2) = q(u2,u1)", "[statement]") {
    const Quadratic g;
    CHECK(g.q(g.u1, g.u2) == g.q(g.u2, g.u1));
}

TEST_CASE("derose-q-prop2: q is affine in each argument, and not linear", "[statement]") {
    Quadratic g;
    const Symbol t = g.variables.next();
    const Symbol w = g.variables.next();
    const Symbol b = g.variables.next();
    CHECK(g.q((1 - b) * t + b * w, g.u2) == (1 - b) * g.q(t, g.u2) + b * g.q(w, g.u2));
    CHECK(g.q(g.u1, (1 - b) * t + b * w) == (1 - b) * g.q(g.u1, t) + b * g.q(g.u1, w));
    // Without a + b = 1: v_0 = v_1 = v_2 = 1 and a = b = 1.
    CHECK(by_casteljau({1, 1, 1}, 0, 1, 1, {t + w, g.u2}) == Symbol(1));
    CHECK(by_casteljau({1, 1, 1}, 0, 1, 1, {t, g.u2}) + by_casteljau({1, 1, 1}, 0, 1, 1, {w, g.u2}) ==
          Symbol(2));
}

TEST_CASE("derose-q-prop3: q(u,u) = Q(u)", "[statement]") {
    const Quadratic g;
    CHECK(g.q(g.u, g.u) == g.curve(g.u));
}

TEST_CASE("derose-q-prop456: q(0,0) = v0, q(0,1) = q(1,0) = v1, q(1,1) = v2", "[statement]") {
    const Quadratic g;
    CHECK(g.q(0, 0) == g.v[0]);
    CHECK(g.q(0, 1) == g.v[1]);
    CHECK(g.q(1, 0) == g.v[1]);
    CHECK(g.q(1, 1) == g.v[2]);
}

TEST_CASE("derose-q-u0: q(u,0) and q(u,1) interpolate between control points", "[statement]") {
    const Quadratic g;
    CHECK(g.q(g.u, 0) == (1 - g.u) * g.q(0, 0) + g.u * g.q(1, 0));
    CHECK(g.q(g.u, 1) == (1 - g.u) * g.q(0, 1) + g.u * g.q(1, 1));
}

TEST_CASE(
    "derose-fig5-ratio: q(u,0) breaks the segment q(0,0) q(1,0) in the ratio u : 1-u, and q(u,1) likewise",
    "[statement]") {
    const Quadratic g;
    for (const int end : {0, 1}) {
        CHECK(g.q(g.u, end) - g.q(0, end) == g.u * (g.q(1, end) - g.q(0, end)));
        CHECK(g.q(1, end) - g.q(g.u, end) == (1 - g.u) * (g.q(1, end) - g.q(0, end)));
    }
}

TEST_CASE("derose-q-uu: q(u,u) = (1-u) q(u,0) + u q(u,1)", "[statement]") {
    const Quadratic g;
    CHECK(g.q(g.u, g.u) == (1 - g.u) * g.q(g.u, 0) + g.u * g.q(g.u, 1));
}
