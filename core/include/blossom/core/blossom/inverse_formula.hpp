#pragma once

#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

namespace blossom {

/// Control points of a simplex patch from values of the map: the point with the i-th multi-index is sum_j
/// weights[i][j] * map(nodes[j]).
struct SimplexInverseFormula {
    std::vector<Coordinates> nodes;              ///< barycentric, in descending lexicographic order
    std::vector<std::vector<Rational>> weights;  ///< one row per control point, in the order of the net
};

/// The inverse formula of degree n on a simplex of dimension s, {s, n}: the polarization formula at i_k
/// copies of vertex k. The nodes are the means J / N of N vertices, J_k copies of vertex k, with the weights
/// (-1)^(n-N) N^n / n! prod_k C(i_k, J_k); the weights of equal nodes are added.
///
/// Exact for polynomials of degree at most n. Cost: at most C(n + s + 1, s + 1) nodes times C(n + s, s)
/// control points. Errors: `limit_exceeded`. Source: Fernandez-Jambrina, corollary 3, equation (23).
/// Statements: fj-eq23, fj-eq23-binom.
SimplexInverseFormula inverse_formula(const SimplexFactor& factor, const Limits& limits = {});

/// A map that can be evaluated at one barycentric point per factor.
using PatchFunction = std::function<Coordinates(const PatchPoint&)>;

/// The control net of this shape that the inverse formula, applied in one factor after the other, gives for a
/// map. The map is called once for each combination of one node per factor.
///
/// It is the net of the map if the map is a polynomial of these degrees. Errors: `mismatched_dimensions` if
/// the values have different dimensions; `limit_exceeded`. Source: Fernandez-Jambrina, equation (23).
/// Statements: fj-eq23, fj-tensor-inverse.
BezierPatch control_net_from_values(const NetShape& shape, const PatchFunction& map,
                                    const Limits& limits = {});

/// The blossom at points from values of the map alone: b[u_1..u_n] = 1/n! sum_N (-1)^(n-N) N^n sum b(mean of
/// N of the u_i), in one factor after the other. In a factor of degree 0 the map is evaluated at the first
/// vertex.
///
/// Cost: prod (m_i + 1) calls, m_i the multiplicities. Errors: those of `require_arguments`; `not_affine` for
/// an argument whose sum is not 1; `limit_exceeded`. Source: Fernandez-Jambrina, equation (21). Statements:
/// fj-eq21, fj-tensor-inverse.
Coordinates blossom_from_values(const NetShape& shape, const PatchFunction& map,
                                const PatchArguments& arguments, const Limits& limits = {});

/// Control points from values of the map alone: P_i = sum_j weights[i][j] * map(nodes[j]).
struct InverseFormula {
    std::vector<Rational> nodes;                 ///< in order from a to b
    std::vector<std::vector<Rational>> weights;  ///< one row per control point, n + 1 of them
};

/// The inverse formula of degree n on [a, b]: the polarization formula at (a^(n-i), b^i). Its nodes are the
/// means ((N - I) a + I b) / N; the weights of equal nodes are added.
///
/// Exact for polynomials of degree at most n; the first and last control points are always the values at the
/// ends. For n >= 3 there are more nodes than control points, and other maps are approximated, without
/// interpolation at inner nodes. Cost: O(n^3) products. Errors: `limit_exceeded`. Source: Fernandez-Jambrina,
/// corollary 2, equation (22). Statements: fj-eq22, fj-reduction-is-lagrange.
InverseFormula inverse_formula(std::size_t n, const Interval& interval, const Limits& limits = {});

/// The control polygon that the inverse formula gives for known values of a map, which must include all
/// nodes. Errors: `missing_sample`, naming the first node without a value; `limit_exceeded`.
BezierCurve control_points_from_samples(std::size_t n, const Interval& interval,
                                        const std::map<Rational, Coordinates>& values,
                                        const Limits& limits = {});

/// The same for a map that can be evaluated; it is called once per node.
BezierCurve control_points_from_values(std::size_t n, const Interval& interval,
                                       const std::function<Coordinates(const Rational&)>& map,
                                       const Limits& limits = {});

}  // namespace blossom
