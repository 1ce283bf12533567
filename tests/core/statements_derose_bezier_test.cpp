// DeRose, Goldman, Lounsbery: A Tutorial Introduction to Blossoming (1991), sections 4.1 to 4.4.
//
// Coefficients, control points, arguments and ends of intervals are symbols: each case decides its statement
// for all of them, at the degrees that it names.

#include <blossom/core/blossom/change_of_basis.hpp>

#include <bit>

#include "support/map_printing.hpp"
#include "support/symbolic_curves.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

/// A blossom of generic coefficients c_0..c_d, and symbols beside them.
struct Generic {
    Variables variables;
    Symbols c;
    SymbolicBlossom q;
    Symbol u;

    explicit Generic(std::size_t d)
        : c(variables.next(d + 1)), q(SymbolicBlossom::of_coefficients(c)), u(variables.next()) {}

    Symbol value(const Symbol& t) const { return polynomial_value(c, t); }
};

/// Figure 6 with the array after every i: v_j = (1 - u_i) v_j + u_i v_{j+1} for j = 0..d-i.
std::vector<Symbols> figure6(Symbols v, const Symbols& u) {
    const std::size_t d = u.size();
    std::vector<Symbols> arrays{v};
    for (std::size_t i = 1; i <= d; ++i) {
        for (std::size_t j = 0; j <= d - i; ++j) v[j] = (1 - u[i - 1]) * v[j] + u[i - 1] * v[j + 1];
        arrays.push_back(v);
    }
    return arrays;
}

}  // namespace

TEST_CASE("derose-42-step: Q(u) = (1-u) q(0,u,..,u) + u q(1,u,..,u), degrees 1 to 7", "[statement]") {
    for (std::size_t d = 1; d <= 7; ++d) {
        const Generic g(d);
        CHECK((1 - g.u) * g.q(runs(1, 0, d - 1, g.u)) + g.u * g.q(runs(1, 1, d - 1, g.u)) == g.value(g.u));
    }
}

TEST_CASE("derose-42-bernstein: the values q(0^(d-i),1^i) are Bernstein coefficients, degrees 0 to 8",
          "[statement]") {
    for (std::size_t d = 0; d <= 8; ++d) {
        const Generic g(d);
        CHECK(bezier_value(end_values(g.q, 0, 1), 0, 1, g.u) == g.value(g.u));
    }
}

TEST_CASE("derose-42-vi: control points on [0,1] are q(0^(d-i),1^i) and unique, degrees 0 to 8",
          "[statement]") {
    for (std::size_t d = 0; d <= 8; ++d) {
        Variables variables;
        const Symbols v = variables.next(d + 1);
        const Symbol u = variables.next();
        // The polynomial alone gives the generic points back, so that no other points have the same
        // polynomial.
        const Symbols coefficients = constructions::local_monomial_from_bernstein(std::span<const Symbol>(v));
        REQUIRE(polynomial_value(coefficients, u) == bezier_value(v, 0, 1, u));
        CHECK(end_values(SymbolicBlossom::of_coefficients(coefficients), 0, 1) == v);
    }
}

TEST_CASE("derose-42-vi-st: control points on [s,t] are q(s^(d-i),t^i), degrees 0 to 5", "[statement]") {
    for (std::size_t d = 0; d <= 5; ++d) {
        Generic g(d);
        const Symbol s = g.variables.next();
        const Symbol t = g.variables.next();
        CHECK(bezier_value(end_values(g.q, s, t), s, t, g.u) == pow(t - s, d) * g.value(g.u));
    }
}

TEST_CASE("derose-42-bezier-blossom: q(u1..ud) as a sum over subsets of control points, degrees 0 to 5",
          "[statement]") {
    for (std::size_t d = 0; d <= 5; ++d) {
        Generic g(d);
        const Symbols u = g.variables.next(d);
        const Symbols v = end_values(g.q, 0, 1);
        Symbols summands;
        for (std::size_t subset = 0; subset < std::size_t{1} << d; ++subset) {
            Symbol term = v[static_cast<std::size_t>(std::popcount(subset))];
            for (std::size_t j = 0; j < d; ++j) term *= (subset >> j & 1) != 0 ? u[j] : 1 - u[j];
            summands.push_back(std::move(term));
        }
        CHECK(sum(summands) == g.q(points(u)));
    }
}

TEST_CASE("derose-fig6-comment: after step i, v_j is q(u1..ui,1^j,0^(d-i-j)), degrees 1 to 5",
          "[statement]") {
    for (std::size_t d = 1; d <= 5; ++d) {
        Generic g(d);
        const Symbols u = g.variables.next(d);
        const auto arrays = figure6(end_values(g.q, 0, 1), u);
        for (std::size_t i = 1; i <= d; ++i) {
            const SymbolicArguments used(u.begin(), u.begin() + static_cast<std::ptrdiff_t>(i));
            for (std::size_t j = 0; j <= d - i; ++j) {
                CHECK(arrays[i][j] == g.q(joined({used, runs(j, 1, d - i - j, 0)})));
            }
        }
    }
}

TEST_CASE("derose-fig6-dcj: figure 6 with equal arguments is de Casteljau's algorithm, degrees 0 to 6",
          "[statement]") {
    for (std::size_t d = 0; d <= 6; ++d) {
        Variables variables;
        const Symbols v = variables.next(d + 1);
        const Symbol u = variables.next();
        const auto arrays = figure6(v, Symbols(d, u));
        const auto pyramid = symbolic_pyramid(v, 0, 1, copies(d, u));
        for (std::size_t i = 0; i <= d; ++i) {
            CHECK(Symbols(arrays[i].begin(), arrays[i].begin() + static_cast<std::ptrdiff_t>(d - i + 1)) ==
                  pyramid[i]);
        }
        CHECK(arrays.back().front() == bezier_value(v, 0, 1, u));
    }
}

TEST_CASE(
    "derose-subdiv-left: q(0^(d-i),u^i) control Q on [0,u] and appear as v_0 in figure 6, degrees 1 to 6",
    "[statement]") {
    for (std::size_t d = 1; d <= 6; ++d) {
        Generic g(d);
        const Symbol w = g.variables.next();
        const Symbols left = end_values(g.q, 0, g.u);
        const auto arrays = figure6(end_values(g.q, 0, 1), Symbols(d, g.u));
        for (std::size_t i = 0; i <= d; ++i) CHECK(arrays[i].front() == left[i]);
        CHECK(bezier_value(left, 0, g.u, w) == pow(g.u, d) * g.value(w));
    }
}

TEST_CASE(
    "derose-subdiv-right: q(u^(d-j),1^j) control Q on [u,1] and are the last array of figure 6, degrees 1 to "
    "6",
    "[statement]") {
    for (std::size_t d = 1; d <= 6; ++d) {
        Generic g(d);
        const Symbol w = g.variables.next();
        const Symbols right = end_values(g.q, g.u, 1);
        CHECK(figure6(end_values(g.q, 0, 1), Symbols(d, g.u)).back() == right);
        CHECK(bezier_value(right, g.u, 1, w) == pow(1 - g.u, d) * g.value(w));
    }
}

TEST_CASE("derose-raise-23: the mean of q over pairs is the tri-affine blossom of a quadratic",
          "[statement]") {
    Generic g(2);
    const Symbols u = g.variables.next(3);
    const Symbol mean = (g.q({u[0], u[1]}) + g.q({u[1], u[2]}) + g.q({u[0], u[2]})) * fraction(1, 3);
    Symbols raised = g.c;
    raised.emplace_back(0);
    CHECK(mean == by_symmetric_functions(raised, points(u)));
}

TEST_CASE("derose-raise-23-points: v0, (v0+2v1)/3, (2v1+v2)/3, v2", "[statement]") {
    Variables variables;
    const Symbols v = variables.next(3);
    const auto q = SymbolicBlossom::of_control_points(v);
    Symbols raised;
    for (const SymbolicArguments& u : {SymbolicArguments{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 1, 1}}) {
        raised.push_back((q({u[0], u[1]}) + q({u[1], u[2]}) + q({u[0], u[2]})) * fraction(1, 3));
    }
    const Symbol third = fraction(1, 3);
    CHECK(raised == Symbols{v[0], (v[0] + 2 * v[1]) * third, (2 * v[1] + v[2]) * third, v[2]});
    const Symbol t = variables.next();
    CHECK(bezier_value(raised, 0, 1, t) == bezier_value(v, 0, 1, t));
}

TEST_CASE(
    "derose-raise-general: the mean of q with each argument omitted is the blossom of degree d+1, degrees 0 "
    "to 5",
    "[statement]") {
    for (std::size_t d = 0; d <= 5; ++d) {
        Generic g(d);
        const SymbolicArguments u = points(g.variables.next(d + 1));
        Symbols summands;
        for (std::size_t i = 0; i <= d; ++i) summands.push_back(g.q(without(u, i)));
        Symbols raised = g.c;
        raised.emplace_back(0);
        CHECK(sum(summands) * fraction(1, d + 1) == by_symmetric_functions(raised, u));
    }
}
