#pragma once

#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <vector>

namespace blossom {

/// The segment on span i as a Bezier curve over [t_i, t_(i+1)], by Sablonniere's algorithm: P_k =
/// f(t_i^(n-k), t_(i+1)^k), by a triangle at t_i and another one at t_(i+1) over its edge.
///
/// Cost: n^2 combinations and divisions of points. Errors: `outside_domain`, `limit_exceeded`.
/// Source: DeRose, figure 9; Hart, "B-spline to Bezier". Statements: derose-fig9-sablonniere,
/// hart-bspline-to-bezier.
BezierCurve sablonniere(const BSplineCurve& curve, std::size_t span, const Limits& limits = {});

/// One Bezier curve for each non-empty span, in order. Cost: that of `sablonniere` per span; memory linear in
/// the spans.
std::vector<BezierCurve> bezier_segments(const BSplineCurve& curve, const Limits& limits = {});

}  // namespace blossom
