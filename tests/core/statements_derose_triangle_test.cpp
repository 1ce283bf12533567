// DeRose, Goldman, Lounsbery: A Tutorial Introduction to Blossoming (1991), sections 5 and 6: triangular
// patches and the abstract data types. Coefficients, control points and arguments are symbols.

#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/geometry/coordinate_free_blossom.hpp>
#include <blossom/core/patch/patch_agreement.hpp>
#include <blossom/core/patch/patch_conversion.hpp>
#include <blossom/core/patch/patch_elevation.hpp>
#include <blossom/core/patch/patch_subdivision.hpp>

#include <algorithm>

#include "support/map_printing.hpp"
#include "support/number_generators.hpp"
#include "support/symbolic_curves.hpp"
#include "support/symbolic_patches.hpp"

using namespace blossom;
using namespace blossom::testing;

namespace {

/// Q(x, y) = sum over i + j <= d of c_ij x^i y^j with symbols c_ij.
struct GenericQ {
    std::size_t d;
    Variables variables;
    Symbols c = variables.next((d + 1) * (d + 2) / 2);

    explicit GenericQ(std::size_t degree) : d(degree) {}

    /// The terms i + j <= d, as a function of x^i y^j.
    template <class Monomial>
    Symbol terms(const Monomial& monomial) const {
        Symbol sum = 0;
        std::size_t place = 0;
        for (std::size_t i = 0; i <= d; ++i) {
            for (std::size_t j = 0; i + j <= d; ++j) sum += c[place++] * monomial(i, j);
        }
        return sum;
    }
    Symbol operator()(const Symbol& x, const Symbol& y) const {
        return terms([&](std::size_t i, std::size_t j) { return pow(x, i) * pow(y, j); });
    }
    /// The blossom with D arguments: the mean of x^i y^j over all ways to choose i of them for x and j others
    /// for y.
    Symbol blossom(const std::vector<Symbols>& points) const {
        const std::size_t D = points.size();
        return terms([&](std::size_t i, std::size_t j) {
            Symbol sum = 0;
            Integer ways;
            std::size_t choices = 1;
            for (std::size_t k = 0; k < D; ++k) choices *= 3;
            for (std::size_t choice = 0; choice < choices; ++choice) {
                Symbol product = 1;
                std::size_t in_x = 0, in_y = 0;
                for (std::size_t k = 0, rest = choice; k < D; ++k, rest /= 3) {
                    if (rest % 3 == 1) product *= points[k][0], ++in_x;
                    if (rest % 3 == 2) product *= points[k][1], ++in_y;
                }
                if (in_x != i || in_y != j) continue;
                sum += product;
                ways += 1;
            }
            return fraction(1, ways) * sum;
        });
    }
};

/// Q and the symmetric functions of points of the engine: coefficients over multinomials at (1, x, y).
Symbol by_symmetric_functions(const GenericQ& q, const std::vector<Symbols>& points) {
    const std::size_t D = points.size();
    Symbols net;
    for (const MultiIndex& index : multi_indices(2, D)) {
        const Symbol coefficient = q.terms(
            [&](std::size_t i, std::size_t j) { return Symbol(i == index[1] && j == index[2] ? 1 : 0); });
        net.push_back(fraction(1, multinomial(index)) * coefficient);
    }
    SymbolTuples tuples;
    for (const Symbols& point : points) tuples.push_back({1, point[0], point[1]});
    const Symbols functions = constructions::times_linear_forms<Symbol>(2, 0, {Symbol(1)}, tuples);
    return dot(net, functions);
}

std::vector<Symbols> generic_plane_points(Variables& variables, std::size_t n) {
    std::vector<Symbols> points;
    for (std::size_t i = 0; i < n; ++i) points.push_back(variables.next(2));
    return points;
}

/// i_k copies of each of r, s, t.
std::vector<Symbols> corner_arguments(const MultiIndex& index, const std::vector<Symbols>& corners) {
    std::vector<Symbols> points;
    for (std::size_t k = 0; k < index.size(); ++k) points.insert(points.end(), index[k], corners[k]);
    return points;
}

/// v_i = q(r^i1, s^i2, t^i3) in the order of the net.
Symbols bezier_points(const GenericQ& q, std::size_t D, const std::vector<Symbols>& corners) {
    Symbols net;
    for (const MultiIndex& index : multi_indices(2, D))
        net.push_back(q.blossom(corner_arguments(index, corners)));
    return net;
}

/// sum a_k corner_k.
Symbols plane_point(const SymbolTuple& weights, const std::vector<Symbols>& corners) {
    Symbols point(2, 0);
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t j = 0; j < 2; ++j) point[j] += weights[k] * corners[k][j];
    }
    return point;
}

/// A generic net of degree n and its blossom at barycentric points.
struct GenericNet {
    std::size_t n;
    Variables variables;
    Symbols v = variables.next((n + 1) * (n + 2) / 2);

    explicit GenericNet(std::size_t degree) : n(degree) {}
    Symbol q(const SymbolTuples& arguments) const {
        return by_casteljau(NetShape::simplex(2, n), v, {arguments});
    }
    const Symbol& at(const MultiIndex& index) const { return v[position(index)]; }
};

}  // namespace

TEST_CASE("derose-thm3", "[statement]") {
    for (std::size_t D = 1; D <= 3; ++D) {
        // Existence, for every degree d <= D: symmetric, affine in each point, Q on the diagonal.
        for (std::size_t d = 0; d <= D; ++d) {
            GenericQ q(d);
            std::vector<Symbols> u = generic_plane_points(q.variables, D);
            const Symbol value = by_symmetric_functions(q, u);
            CHECK(value == q.blossom(u));
            const Symbols p = q.variables.next(2), r = q.variables.next(2);
            const Symbol a = q.variables.next();
            std::vector<Symbols> both = u, first = u, second = u, swapped = u;
            both[0] = {(1 - a) * p[0] + a * r[0], (1 - a) * p[1] + a * r[1]};
            first[0] = p, second[0] = r;
            CHECK(by_symmetric_functions(q, both) ==
                  (1 - a) * by_symmetric_functions(q, first) + a * by_symmetric_functions(q, second));
            std::ranges::rotate(swapped, swapped.begin() + 1);
            CHECK(by_symmetric_functions(q, swapped) == value);
            CHECK(by_symmetric_functions(q, std::vector<Symbols>(D, p)) == q(p[0], p[1]));
        }
        // Uniqueness: a D-affine function has 3^D coefficients; symmetry and zero on the diagonal leave none.
        Variables variables;
        std::size_t unknowns = 1;
        for (std::size_t k = 0; k < D; ++k) unknowns *= 3;
        const Symbols e = variables.next(unknowns);
        const std::vector<Symbols> u = generic_plane_points(variables, D);
        const auto multiaffine = [&](const std::vector<Symbols>& points) {
            Symbol sum = 0;
            for (std::size_t choice = 0; choice < unknowns; ++choice) {
                Symbol product = e[choice];
                for (std::size_t k = 0, rest = choice; k < D; ++k, rest /= 3) {
                    if (rest % 3 > 0) product *= points[k][rest % 3 - 1];
                }
                sum += product;
            }
            return sum;
        };
        Symbols conditions{multiaffine(std::vector<Symbols>(D, u[0]))};
        for (std::size_t k = 0; k + 1 < D; ++k) {
            std::vector<Symbols> swapped = u;
            std::swap(swapped[k], swapped[k + 1]);
            conditions.push_back(multiaffine(swapped) - multiaffine(u));
        }
        CHECK(rank_of_conditions(conditions, unknowns) == unknowns);
        if (D > 1) CHECK(rank_of_conditions({conditions[0]}, unknowns) < unknowns);
    }
    // The engine proves the agreement of its constructions for every point of the plane.
    const std::vector<SparsePolynomial> coordinates{
        SparsePolynomial::variable(0) * SparsePolynomial::variable(1) + 3};
    CHECK(agreement_for_all_arguments(PolynomialPatch(NetShape::simplex(2, 3), coordinates)).agree());
}

TEST_CASE("derose-tri-points", "[statement]") {
    for (std::size_t d = 1; d <= 3; ++d) {
        GenericQ q(d);
        const std::vector<Symbols> corners = generic_plane_points(q.variables, 3);
        const SymbolTuple a = generic_point(q.variables, 2);
        const Symbols point = plane_point(a, corners);
        CHECK(triangle_value(d, bezier_points(q, d, corners), a) == q(point[0], point[1]));
    }
}

TEST_CASE("derose-tri-eval", "[statement]") {
    GenericQ q(2);
    const std::vector<Symbols> corners = generic_plane_points(q.variables, 3);
    const SymbolTuple a = generic_point(q.variables, 2);
    const Symbols u = plane_point(a, corners);
    Symbol by_u = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        by_u += a[k] * q.blossom({corners[k], u});
        Symbol by_corners = 0;
        for (std::size_t l = 0; l < 3; ++l) by_corners += a[l] * q.blossom({corners[k], corners[l]});
        CHECK(q.blossom({corners[k], u}) == by_corners);
    }
    CHECK(q.blossom({u, u}) == by_u);
    CHECK(by_u == q(u[0], u[1]));
    // Two steps of the engine.
    const NetShape shape = NetShape::simplex(2, 2);
    const Symbols level = constructions::fold<Symbol>(shape, 0, bezier_points(q, 2, corners), a);
    CHECK(level ==
          Symbols{q.blossom({corners[0], u}), q.blossom({corners[1], u}), q.blossom({corners[2], u})});
    CHECK(constructions::fold<Symbol>(shape.with_degree(0, 1), 0, level, a) == Symbols{by_u});
}

TEST_CASE("derose-tri-subdiv", "[statement]") {
    for (std::size_t n = 2; n <= 3; ++n) {
        GenericNet g(n);
        const SymbolTuple u = generic_point(g.variables, 2), x = generic_point(g.variables, 2);
        const NetShape shape = NetShape::simplex(2, n);
        const auto levels = constructions::pyramid<Symbol>(shape, 0, g.v, u);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            SymbolTuples elements{vertex(2, 0), vertex(2, 1), vertex(2, 2)};
            elements[corner] = u;
            Symbols expected;
            for (const MultiIndex& index : multi_indices(2, n))
                expected.push_back(g.q(copies(index, elements)));
            const Symbols piece = constructions::with_vertex_replaced<Symbol>(shape, 0, corner, levels);
            CHECK(piece == expected);
            // The sub-net is the map at x_0 e_0 + x_1 e_1 + x_2 e_2.
            SymbolTuple point(3, 0);
            for (std::size_t k = 0; k < 3; ++k) {
                for (std::size_t j = 0; j < 3; ++j) point[j] += x[k] * elements[k][j];
            }
            CHECK(triangle_value(n, piece, x) == triangle_value(n, g.v, point));
        }
    }
    // u must not lie on an edge for all three pieces to be triangles.
    const BezierPatch patch(NetShape::simplex(2, 1), std::vector<Coordinates>{{0}, {1}, {2}});
    const Rational half(1, 2);
    CHECK_THROWS_AS(subdivide(patch, 0, {0, half, half}), Error);
}

TEST_CASE("derose-tri-raise", "[statement]") {
    GenericQ q(2);
    const std::vector<Symbols> u = generic_plane_points(q.variables, 3);
    CHECK(q.blossom(u) ==
          fraction(1, 3) * (q.blossom({u[0], u[1]}) + q.blossom({u[1], u[2]}) + q.blossom({u[0], u[2]})));
}

TEST_CASE("derose-tri-raise-points", "[statement]") {
    // v~_i = sum_k i_k / (n + 1) v_(i - e_k) controls the same map.
    for (std::size_t n = 1; n <= 3; ++n) {
        GenericNet g(n);
        Symbols raised;
        for (const MultiIndex& index : multi_indices(2, n + 1)) {
            Symbol point = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                if (index[k] == 0) continue;
                MultiIndex lower = index;
                --lower[k];
                point += fraction(index[k], n + 1) * g.at(lower);
            }
            raised.push_back(point);
        }
        const SymbolTuple x = generic_point(g.variables, 2);
        CHECK(triangle_value(n + 1, raised, x) == triangle_value(n, g.v, x));
        if (n == 2) {
            CHECK(raised[position(MultiIndex{3, 0, 0})] == g.at({2, 0, 0}));
            CHECK(raised[position(MultiIndex{1, 1, 1})] ==
                  fraction(1, 3) * (g.at({1, 1, 0}) + g.at({0, 1, 1}) + g.at({1, 0, 1})));
        }
    }
    // The engine raises by the same rule, one unit net after the other.
    for (std::size_t place = 0; place < 6; ++place) {
        std::vector<Coordinates> net(6, Coordinates{0});
        net[place] = {1};
        const std::vector<Coordinates> raised =
            elevate(BezierPatch(NetShape::simplex(2, 2), net), 0, 1).control_net().to_points();
        const auto indices = multi_indices(2, 3);
        for (std::size_t i = 0; i < indices.size(); ++i) {
            Rational expected;
            for (std::size_t k = 0; k < 3; ++k) {
                MultiIndex lower = indices[i];
                if (lower[k]-- == 0 || position(lower) != place) continue;
                expected += Rational(indices[i][k], 3);
            }
            CHECK(raised[i][0] == expected);
        }
    }
}

TEST_CASE("derose-adt-affinemap", "[statement]") {
    // M := AffineMapCreate(r, s, t, R, S, T); AffineMapEvaluate(M, p), which is a blossom of one argument.
    Random random(911);
    const geometry::Space plane(2), space(3);
    for (int round = 0; round < 20; ++round) {
        const auto point = [&](const geometry::Space& of) {
            Coordinates coordinates;
            for (std::size_t i = 0; i < of.dimension(); ++i) coordinates.push_back(small_rational(random));
            return of.point(coordinates);
        };
        const geometry::Simplex rst({plane.point({0, 0}), plane.point({2, 1}), plane.point({-1, 3})});
        const std::vector<geometry::Point> images{point(space), point(space), point(space)};
        const geometry::AffineMap map(rst, images);
        const geometry::Blossom q = geometry::Blossom::from_affine_map(map);
        const geometry::Point p = point(plane);
        CHECK(map(rst.vertices()[1]) == images[1]);
        CHECK(map(p) == affine_combination(images, rst.barycentric(p)));
        CHECK(q(std::vector{p}) == map(p));
    }
}

TEST_CASE("derose-adt-blossom", "[statement]") {
    // BlossomEvaluate is the triangular de Casteljau with one barycentric triple a level; figure 10 serves
    // curves alone. Level by level here, against the sum over all assignments of vertices.
    for (std::size_t n = 1; n <= 3; ++n) {
        GenericNet g(n);
        const SymbolTuples u = generic_points(g.variables, 2, n);
        Symbol sum = 0;
        std::size_t choices = 1;
        for (std::size_t k = 0; k < n; ++k) choices *= 3;
        for (std::size_t choice = 0; choice < choices; ++choice) {
            Symbol product = 1;
            MultiIndex index(3);
            for (std::size_t k = 0, rest = choice; k < n; ++k, rest /= 3) {
                product *= u[k][rest % 3];
                ++index[rest % 3];
            }
            sum += product * g.at(index);
        }
        CHECK(g.q(u) == sum);
    }
    const geometry::Space plane(2), line(1);
    const geometry::Simplex rst({plane.point({0, 0}), plane.point({1, 0}), plane.point({0, 1})});
    std::vector<geometry::Point> net;
    for (const int value : {0, 1, 2, 4, 8, 16}) net.push_back(line.point({value}));
    const geometry::Blossom q = geometry::Blossom::from_bezier_net(rst, 2, net);
    CHECK(q(std::vector{plane.point({0, 0}), plane.point({0, 1})}) == line.point({2}));
    CHECK(q(std::vector{plane.point({1, 1}), plane.point({1, 0})}) == line.point({-1 + 4 + 8}));
}
