#pragma once

#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <functional>
#include <map>
#include <vector>

namespace blossom {

/// Control points from values of a map alone: P_i = sum_j weights[i][j] * map(nodes[j]).
struct InverseFormula {
    std::vector<Rational> nodes;                 ///< in order from a to b
    std::vector<std::vector<Rational>> weights;  ///< one row a control point, n + 1 of them
};

/// The inverse formula of degree n on [a, b]: the polarization formula at (a^(n-i), b^i), whose nodes are the
/// means
/// ((N - I) a + I b) / N, with equal nodes taken together.
///
/// Exact for polynomials of degree at most n; the first and last control points are always the values at the
/// ends. For n >= 3 there are more nodes than control points, and other maps are approximated, not
/// interpolated at inner nodes. Cost: O(n^3) products. Errors: `limit_exceeded`. Source: Fernandez-Jambrina,
/// corollary 2, equation (22). Statements: fj-eq22, fj-reduction-is-lagrange.
InverseFormula inverse_formula(std::size_t n, const Interval& interval, const Limits& limits = {});

/// The control polygon that the inverse formula gives for known values of a map; all its nodes must be among
/// them. Errors: `missing_sample`, naming the first node without a value; `limit_exceeded`.
BezierCurve control_points_from_samples(std::size_t n, const Interval& interval,
                                        const std::map<Rational, Coordinates>& values,
                                        const Limits& limits = {});

/// The same for a map that can be evaluated; it is called once a node.
BezierCurve control_points_from_values(std::size_t n, const Interval& interval,
                                       const std::function<Coordinates(const Rational&)>& map,
                                       const Limits& limits = {});

}  // namespace blossom
