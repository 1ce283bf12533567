#pragma once

#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <functional>
#include <vector>

namespace blossom {

/// Control points of a simplex patch from values of a map alone: the point with the i-th multi-index is sum_j
/// weights[i][j] * map(nodes[j]).
struct SimplexInverseFormula {
    std::vector<Coordinates> nodes;              ///< barycentric, lexicographically descending
    std::vector<std::vector<Rational>> weights;  ///< one row a control point, in the order of the net
};

/// The inverse formula of degree n on a simplex of dimension s: the polarization formula at i_k copies of
/// vertex k. The nodes are the means J / N of N vertices, J_k copies of vertex k, with the weights (-1)^(n-N)
/// N^n / n! prod_k C(i_k, J_k); equal nodes are taken together.
///
/// Exact for polynomials of degree at most n. Cost: C(n + s + 1, s + 1) nodes times C(n + s, s) control
/// points, at most. Errors: `limit_exceeded`. Source: Fernandez-Jambrina, corollary 3, equation (23).
/// Statements: fj-eq23, fj-eq23-binom.
SimplexInverseFormula inverse_formula(std::size_t dimension, std::size_t degree, const Limits& limits = {});

/// A map that can be evaluated, at one barycentric point a factor.
using PatchValues = std::function<Coordinates(const PatchPoint&)>;

/// The control net of that shape which the inverse formula gives for a map, applied in one factor after the
/// other; the map is called once for each choice of a node a factor.
///
/// It is the net of the map when that is a polynomial of these degrees. Errors: `mismatched_dimensions` if
/// the values have different dimensions; `limit_exceeded`. Source: Fernandez-Jambrina, equation (23).
/// Statements: fj-eq23, fj-tensor-inverse.
BezierPatch control_net_from_values(const NetShape& shape, const PatchValues& map, const Limits& limits = {});

/// The blossom at points from values of a map alone: b[u_1..u_n] = 1/n! sum_N (-1)^(n-N) N^n sum b(mean of N
/// of the u_i), in one factor after the other. In a factor of degree 0 the map is taken at the first vertex.
///
/// Cost: prod (m_i + 1) calls, m_i the multiplicities. Errors: those of `require_arguments`; `not_affine` for
/// an argument whose sum is not 1; `limit_exceeded`. Source: Fernandez-Jambrina, equation (21). Statements:
/// fj-eq21, fj-tensor-inverse.
Coordinates blossom_from_values(const NetShape& shape, const PatchValues& map,
                                const PatchArguments& arguments, const Limits& limits = {});

}  // namespace blossom
