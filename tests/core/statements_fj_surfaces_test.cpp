// Fernandez-Jambrina: Inverse Relations for Blossoms and Parametrisations of Rational Curves and Surfaces
// (2024): tensor product patches and Bezier triangles. Control points and arguments are symbols.

#include <blossom/core/patch/patch_inverse_formula.hpp>

#include <numeric>

#include "support/failure.hpp"
#include "support/map_printing.hpp"
#include "support/symbolic_curves.hpp"
#include "support/symbolic_patches.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

const std::pair<std::size_t, std::size_t> degrees[] = {{1, 2}, {2, 2}, {2, 3}};

/// The blossom of one polygon over [0, 1].
Symbol polygon_blossom(const Symbols& polygon, const Symbols& arguments) {
    return testing::by_casteljau(polygon, 0, 1, 1, testing::points(arguments));
}

Symbol mean_value(std::size_t n, const Symbols& net, const SymbolTuples& points) {
    SymbolTuple mean(3, 0);
    for (const SymbolTuple& point : points) {
        for (std::size_t k = 0; k < 3; ++k) mean[k] += fraction(1, points.size()) * point[k];
    }
    return triangle_value(n, net, mean);
}

/// Equation (21) as printed.
Symbol equation_21(std::size_t n, const Symbols& net, const SymbolTuples& u) {
    Symbol sum = 0;
    for (std::size_t subset = 1; subset < std::size_t{1} << n; ++subset) {
        SymbolTuples chosen;
        for (std::size_t i = 0; i < n; ++i) {
            if ((subset >> i & 1) != 0) chosen.push_back(u[i]);
        }
        const Integer weight =
            pow(Integer(chosen.size()), n) * Integer((n - chosen.size()) % 2 == 0 ? 1 : -1);
        sum += scaled(weight, mean_value(n, net, chosen));
    }
    return fraction(1, factorial(n)) * sum;
}

/// Equation (23) as printed, for one (i, j, k).
Symbol equation_23(const MultiIndex& index, const Symbols& net, const SymbolTuples& abc) {
    const std::size_t n = std::accumulate(index.begin(), index.end(), std::size_t{0});
    Symbol sum = 0;
    for (std::size_t count = 1; count <= n; ++count) {
        for (std::size_t J = 0; J <= index[1]; ++J) {
            for (std::size_t K = 0; K <= index[2]; ++K) {
                if (J + K > count) continue;  // the binomial with a negative entry
                const Integer weight = binomial(index[1], J) * binomial(index[2], K) *
                                       binomial(index[0], count - J - K) * pow(Integer(count), n) *
                                       Integer((n - count) % 2 == 0 ? 1 : -1);
                if (weight.is_zero()) continue;
                sum += scaled(weight, mean_value(n, net, copies({count - J - K, J, K}, abc)));
            }
        }
    }
    return fraction(1, factorial(n)) * sum;
}

}  // namespace

TEST_CASE("fj-tensor-matrix", "[statement]") {
    Variables variables;
    const std::size_t m = 2, n = 3;
    const Symbols b = variables.next((m + 1) * (n + 1));
    const Symbol u = variables.next(), v = variables.next();
    Symbol product = 0;
    for (std::size_t i = 0; i <= m; ++i) {
        Symbol row = 0;
        for (std::size_t j = 0; j <= n; ++j) row += b[i * (n + 1) + j] * bernstein(n, j, v);
        product += bernstein(m, i, u) * row;
    }
    CHECK(by_casteljau(tensor_shape({m, n}), b,
                       {SymbolTuples(m, on_segment(u)), SymbolTuples(n, on_segment(v))}) == product);
}

TEST_CASE("fj-eq9", "[statement]") {
    for (const auto& [m, n] : degrees) {
        Variables variables;
        const Symbols b = variables.next((m + 1) * (n + 1));
        const Symbols u = variables.next(m), v = variables.next(n);
        // Columns first with the u, rows first with the v.
        Symbols by_columns, by_rows;
        for (std::size_t j = 0; j <= n; ++j) {
            Symbols column;
            for (std::size_t i = 0; i <= m; ++i) column.push_back(b[i * (n + 1) + j]);
            by_columns.push_back(polygon_blossom(column, u));
        }
        for (std::size_t i = 0; i <= m; ++i) {
            const auto begin = b.begin() + static_cast<std::ptrdiff_t>(i * (n + 1));
            by_rows.push_back(polygon_blossom(Symbols(begin, begin + static_cast<std::ptrdiff_t>(n + 1)), v));
        }
        const Symbol value = polygon_blossom(by_columns, v);
        CHECK(polygon_blossom(by_rows, u) == value);
        SymbolTuples first, second;
        for (const Symbol& x : u) first.push_back(on_segment(x));
        for (const Symbol& x : v) second.push_back(on_segment(x));
        CHECK(by_casteljau(tensor_shape({m, n}), b, {first, second}) == value);
    }
}

TEST_CASE("fj-tri-def", "[statement]") {
    // The Bernstein polynomials of a triangle have the sum 1, and de Casteljau with equal triples is the sum.
    for (std::size_t n = 0; n <= 5; ++n) {
        Variables variables;
        const SymbolTuple x = generic_point(variables, 2);
        const std::size_t size = (n + 1) * (n + 2) / 2;
        CHECK(triangle_value(n, Symbols(size, 1), x) == Symbol(1));
        if (n > 3) continue;
        const Symbols b = variables.next(size);
        CHECK(by_casteljau(NetShape::simplex(2, n), b, {SymbolTuples(n, x)}) == triangle_value(n, b, x));
    }
}

TEST_CASE("fj-tri-blossom", "[statement]") {
    // b_ijk^(r) = u_r b_(i+1)jk^(r-1) + v_r b_i(j+1)k^(r-1) + w_r b_ij(k+1)^(r-1): the left-hand side of the
    // second line needs all three indices. With one, b_i^(r), the entries (0,1,0) and (0,0,1) of degree n - r
    // = 1 would be one number, and they differ.
    for (std::size_t n = 1; n <= 4; ++n) {
        Variables variables;
        const Symbols b = variables.next((n + 1) * (n + 2) / 2);
        const SymbolTuples u = generic_points(variables, 2, n);
        Symbols level = b;
        for (std::size_t r = 1; r <= n; ++r) {
            Symbols next;
            for (const MultiIndex& index : multi_indices(2, n - r)) {
                Symbol entry = 0;
                for (std::size_t k = 0; k < 3; ++k) {
                    MultiIndex above = index;
                    ++above[k];
                    entry += u[r - 1][k] * level[position(above)];
                }
                next.push_back(entry);
            }
            level = next;
            if (n - r == 1) CHECK(level[1] != level[2]);
        }
        CHECK(by_casteljau(NetShape::simplex(2, n), b, {u}) == level.front());
        if (n <= 3) CHECK(equation_21(n, b, u) == level.front());
    }
}

TEST_CASE("fj-eq21", "[statement]") {
    for (std::size_t n = 1; n <= 3; ++n) {
        Variables variables;
        const Symbols b = variables.next((n + 1) * (n + 2) / 2);
        const SymbolTuples u = generic_points(variables, 2, n);
        const Symbol value = by_casteljau(NetShape::simplex(2, n), b, {u});
        CHECK(equation_21(n, b, u) == value);
        // The engine, from values of the homogeneous polynomial.
        const NetShape shape = NetShape::simplex(2, n);
        const auto form = [&](const SymbolTuples& sums, const std::vector<std::size_t>&) {
            return Symbols{triangle_value(n, b, sums.front())};
        };
        const std::vector<constructions::Groups<SymbolTuple>> groups{constructions::grouped<SymbolTuple>(u)};
        const Symbols polarized = constructions::polarized<Symbol>(shape, groups, form);
        CHECK(fraction(1, factorial(n)) * polarized.front() == value);
    }
}

TEST_CASE("fj-tensor-inverse", "[statement]") {
    for (const auto& [m, n] : {std::pair<std::size_t, std::size_t>{2, 1}, {2, 2}, {2, 3}}) {
        Variables variables;
        const NetShape shape = tensor_shape({m, n});
        const Symbols b = variables.next((m + 1) * (n + 1));
        const SymbolTuples u = generic_points(variables, 1, m), v = generic_points(variables, 1, n);
        const auto form = [&](const SymbolTuples& sums, const std::vector<std::size_t>&) {
            Symbol value = 0;
            for (std::size_t i = 0; i <= m; ++i) {
                for (std::size_t j = 0; j <= n; ++j) {
                    value += scaled(binomial(m, i) * binomial(n, j),
                                    b[i * (n + 1) + j] * pow(sums[0][0], m - i) * pow(sums[0][1], i) *
                                        pow(sums[1][0], n - j) * pow(sums[1][1], j));
                }
            }
            return Symbols{value};
        };
        const std::vector<constructions::Groups<SymbolTuple>> groups{constructions::grouped<SymbolTuple>(u),
                                                                     constructions::grouped<SymbolTuple>(v)};
        const Symbols polarized = constructions::polarized<Symbol>(shape, groups, form);
        CHECK(fraction(1, factorial(m) * factorial(n)) * polarized.front() == by_casteljau(shape, b, {u, v}));
    }
}

TEST_CASE("fj-eq23", "[statement]") {
    for (std::size_t n = 1; n <= 3; ++n) {
        Variables variables;
        const Symbols b = variables.next((n + 1) * (n + 2) / 2);
        const SymbolTuples abc = generic_points(variables, 2, 3);
        const SimplexInverseFormula formula = inverse_formula(2, n);
        const auto indices = multi_indices(2, n);
        for (std::size_t i = 0; i < indices.size(); ++i) {
            const Symbol vertex = by_casteljau(NetShape::simplex(2, n), b, {copies(indices[i], abc)});
            CHECK(equation_23(indices[i], b, abc) == vertex);
            // The engine's table: values at the nodes of the triangle a, b, c.
            Symbol tabled = 0;
            for (std::size_t j = 0; j < formula.nodes.size(); ++j) {
                if (formula.weights[i][j].is_zero()) continue;
                SymbolTuple point(3, 0);
                for (std::size_t k = 0; k < 3; ++k) {
                    for (std::size_t l = 0; l < 3; ++l) point[l] += Symbol(formula.nodes[j][k]) * abc[k][l];
                }
                tabled += Symbol(formula.weights[i][j]) * triangle_value(n, b, point);
            }
            CHECK(tabled == vertex);
        }
    }
    // The degrees 4 and 5 on the reference triangle, for all nets: the weights reproduce each unit net.
    for (std::size_t n = 4; n <= 5; ++n) {
        const SimplexInverseFormula formula = inverse_formula(2, n);
        const auto indices = multi_indices(2, n);
        for (std::size_t i = 0; i < indices.size(); ++i) {
            for (std::size_t l = 0; l < indices.size(); ++l) {
                Rational sum;
                for (std::size_t j = 0; j < formula.nodes.size(); ++j) {
                    Rational value = multinomial(indices[l]);
                    for (std::size_t k = 0; k < 3; ++k) value *= pow(formula.nodes[j][k], indices[l][k]);
                    sum += formula.weights[i][j] * value;
                }
                CHECK(sum == (i == l ? 1 : 0));
            }
        }
    }
    // The printed index set 1 <= i, j, k misses the boundary: no index for n < 3, one of ten for n = 3.
    for (std::size_t n = 1; n <= 3; ++n) {
        std::size_t printed = 0;
        for (const MultiIndex& index : multi_indices(2, n)) {
            printed += static_cast<std::size_t>(index[0] >= 1 && index[1] >= 1 && index[2] >= 1);
        }
        CHECK(printed == (n < 3 ? 0 : 1));
    }
    // And b(u, w, w) is not a value of the patch: for the net of (u, v, w) -> v at (1/2, 1/2, 0) it would be
    // 0.
    const Rational half(1, 2);
    CHECK(triangle_value(1, {0, 1, 0}, {half, half, 0}) == Symbol(half));
    CHECK(triangle_value(1, {0, 1, 0}, {half, 0, 0}) == Symbol(0));
}

TEST_CASE("fj-eq23-binom", "[statement]") {
    for (std::size_t i = 0; i <= 6; ++i) {
        for (std::size_t count = 1; count <= 12; ++count) {
            for (std::size_t J = 0; J <= count; ++J) {
                for (std::size_t K = 0; J + K <= count; ++K) {
                    CHECK(binomial(i, count - J - K).is_zero() == (count - J - K > i));
                }
            }
        }
    }
}
