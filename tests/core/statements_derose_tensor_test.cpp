// DeRose, Goldman, Lounsbery: A Tutorial Introduction to Blossoming (1991), section 5: tensor product
// surfaces. Control points and arguments are symbols.

#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/patch/patch_elevation.hpp>

#include "support/map_printing.hpp"
#include "support/symbolic_curves.hpp"
#include "support/symbolic_patches.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

struct Generic {
    std::size_t m;
    std::size_t n;
    NetShape shape = tensor_shape({m, n});
    Variables variables;
    Symbols w = variables.next((m + 1) * (n + 1));
    SymbolTuples u = generic_points(variables, 1, m);
    SymbolTuples v = generic_points(variables, 1, n);

    Generic(std::size_t first, std::size_t second) : m(first), n(second) {}

    const Symbol& net(std::size_t i, std::size_t j) const { return w[i * (n + 1) + j]; }
    /// F(u, v) = sum w_ij b_i(u) b_j(v).
    Symbol surface(const Symbol& at_u, const Symbol& at_v) const {
        Symbol sum = 0;
        for (std::size_t i = 0; i <= m; ++i) {
            for (std::size_t j = 0; j <= n; ++j)
                sum += net(i, j) * bernstein(m, i, at_u) * bernstein(n, j, at_v);
        }
        return sum;
    }
    Symbol f(const SymbolTuples& first, const SymbolTuples& second) const {
        return by_casteljau(shape, w, {first, second});
    }
};

const std::pair<std::size_t, std::size_t> degrees[] = {{1, 1}, {2, 1}, {2, 2}, {3, 2}};

}  // namespace

TEST_CASE("derose-tensor-def", "[statement]") {
    for (const auto& [m, n] : degrees) {
        Generic g(m, n);
        const Symbol u = g.variables.next(), v = g.variables.next();
        CHECK(g.f(SymbolTuples(m, on_segment(u)), SymbolTuples(n, on_segment(v))) == g.surface(u, v));
    }
}

TEST_CASE("derose-tensor-props", "[statement]") {
    for (const auto& [m, n] : degrees) {
        Generic g(m, n);
        const Symbol x = g.variables.next(), y = g.variables.next(), a = g.variables.next();
        const SymbolTuple mixed = on_segment((1 - a) * x + a * y);
        // (1) affine in each argument.
        for (std::size_t i = 0; i < m; ++i) {
            SymbolTuples both = g.u, first = g.u, second = g.u;
            both[i] = mixed, first[i] = on_segment(x), second[i] = on_segment(y);
            CHECK(g.f(both, g.v) == (1 - a) * g.f(first, g.v) + a * g.f(second, g.v));
        }
        for (std::size_t j = 0; j < n; ++j) {
            SymbolTuples both = g.v, first = g.v, second = g.v;
            both[j] = mixed, first[j] = on_segment(x), second[j] = on_segment(y);
            CHECK(g.f(g.u, both) == (1 - a) * g.f(g.u, first) + a * g.f(g.u, second));
        }
        // (2), (3) symmetric in the u and in the v.
        for (std::size_t i = 0; i + 1 < m; ++i) {
            SymbolTuples exchanged = g.u;
            std::swap(exchanged[i], exchanged[i + 1]);
            CHECK(g.f(exchanged, g.v) == g.f(g.u, g.v));
        }
        for (std::size_t j = 0; j + 1 < n; ++j) {
            SymbolTuples exchanged = g.v;
            std::swap(exchanged[j], exchanged[j + 1]);
            CHECK(g.f(g.u, exchanged) == g.f(g.u, g.v));
        }
        // (4) F on the diagonal.
        CHECK(g.f(SymbolTuples(m, on_segment(x)), SymbolTuples(n, on_segment(y))) == g.surface(x, y));
    }
}

TEST_CASE("derose-tensor-asym", "[statement]") {
    // F(u, v) = u with D = 1: f(u1; v1) = u1, and f(v1; u1) = v1.
    const BezierPatch patch(tensor_shape({1, 1}), std::vector<Coordinates>{{0}, {0}, {1}, {1}});
    const Coordinates at_2{-1, 2}, at_5{-4, 5};
    CHECK(blossom_value(patch, {{at_2}, {at_5}}) == Coordinates{2});
    CHECK(blossom_value(patch, {{at_5}, {at_2}}) == Coordinates{5});
}

TEST_CASE("derose-tensor-allresults", "[statement]") {
    // The values w_ij = f(a^(m-i), b^i; c^(n-j), d^j) are the control points over [a, b] x [c, d]: at (1 - s)
    // a
    // + s b and (1 - t) c + t d their surface is F.
    Generic g(2, 1);
    const Symbols ends = g.variables.next(4);
    const Symbol s = g.variables.next(), t = g.variables.next();
    Generic part(2, 1);
    part.w.clear();
    for (std::size_t i = 0; i <= 2; ++i) {
        for (std::size_t j = 0; j <= 1; ++j) {
            part.w.push_back(g.f(copies({2 - i, i}, {on_segment(ends[0]), on_segment(ends[1])}),
                                 copies({1 - j, j}, {on_segment(ends[2]), on_segment(ends[3])})));
        }
    }
    CHECK(part.surface(s, t) == g.surface((1 - s) * ends[0] + s * ends[1], (1 - t) * ends[2] + t * ends[3]));

    // Raising the degree in u: f~(u1, u2, u3; v) is the mean over the pairs of u.
    const SymbolTuples u = generic_points(g.variables, 1, 3);
    Symbols raised;
    for (std::size_t i = 0; i <= 3; ++i) {
        for (std::size_t j = 0; j <= 1; ++j) {
            Symbol point = 0;
            if (i > 0) point += scaled(i, g.net(i - 1, j));
            if (i < 3) point += scaled(3 - i, g.net(i, j));
            raised.push_back(fraction(1, 3) * point);
        }
    }
    const Symbol mean =
        fraction(1, 3) * (g.f({u[0], u[1]}, g.v) + g.f({u[0], u[2]}, g.v) + g.f({u[1], u[2]}, g.v));
    CHECK(by_casteljau(tensor_shape({3, 1}), raised, {u, g.v}) == mean);
    // The engine raises by the same rule.
    const BezierPatch patch(tensor_shape({2, 1}), std::vector<Coordinates>{{0}, {3}, {6}, {0}, {3}, {9}});
    CHECK(elevate(patch, 0, 1).control_net().to_points() ==
          std::vector<Coordinates>{{0}, {3}, {4}, {1}, {5}, {3}, {3}, {9}});
}
