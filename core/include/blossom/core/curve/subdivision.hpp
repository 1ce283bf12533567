#pragma once

#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <span>
#include <utility>
#include <vector>

namespace blossom {

/// De Casteljau's pyramid with one argument per level, with all its nodes.
///
/// Level r has n + 1 - r points; point i of it is p(a^(n-r-i), b^i, u_1, ..., u_r). Level 0 is the control
/// polygon, and the apex is p(u_1, ..., u_n). With all arguments equal to t it is the evaluation of the curve
/// at t. Source: DeRose, figure 6; Goldman, figure 3. Statements: derose-fig6-comment, goldman-fig3,
/// blog-intermediate.
struct Pyramid {
    std::vector<PointArray> levels;

    Coordinates apex() const { return levels.back()[0]; }
};

/// The pyramid of n arguments, n the degree. Cost: n^2 / 2 combinations of points; each level is made
/// canonical. Errors: `wrong_arity`, `limit_exceeded`.
Pyramid casteljau_pyramid(const BezierCurve& curve, std::span<const Argument> arguments,
                          const Limits& limits = {});

/// The control polygons over [a, t] and [t, b]: Q_k = p(a^(n-k), t^k) and R_k = p(t^(n-k), b^k), the lateral
/// edges of the pyramid at t. The parameter may lie outside [a, b].
///
/// Cost: that of two changes of the interval, see `control_points`; only the result takes memory.
/// Errors: `empty_interval` if t is a or b; `limit_exceeded`.
/// Source: Goldman, section 3; DeRose, section 4.3. Statements: goldman-subdivision, derose-subdiv-left,
/// derose-subdiv-right.
std::pair<BezierCurve, BezierCurve> subdivide(const BezierCurve& curve, const Parameter& t,
                                              const Limits& limits = {});

}  // namespace blossom
