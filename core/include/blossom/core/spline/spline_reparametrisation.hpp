#pragma once

#include <blossom/core/curve/reparametrisation.hpp>
#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/rational/limits.hpp>

namespace blossom {

/// The spline whose point at c(t) is that of `curve` at t: its knots are c(t_i), with the same control
/// points, both from the other end where c reverses the direction. Cost: a product a knot.
BSplineCurve reparametrised(const BSplineCurve& curve, const ParameterChange& change, const Limits& = {});

}  // namespace blossom
