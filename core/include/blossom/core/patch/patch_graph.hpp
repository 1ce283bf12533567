#pragma once

#include <blossom/core/maps/barycentric_frame.hpp>
#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/core/maps/polynomial_patch.hpp>
#include <blossom/core/patch/tensor_bspline.hpp>
#include <blossom/core/spline/graph.hpp>
#include <blossom/rational/limits.hpp>

#include <span>

namespace blossom {

/// The map (x, P(x)), with the coordinates of the parameter in front; see `graph` of curves.
///
/// The blossom of x is the mean of its arguments, so that a control point has the mean of the vertices at
/// which it is the blossom value in front. A degree 0 is raised to 1. With weights the coordinates are x
/// w(x), and every degree rises by one. Without frames the parameters are barycentric coordinates. Cost: the
/// products of w with the coordinates of x. Errors: `limit_exceeded`. Source: Goldman, exercise 9. Statement:
/// goldman-ex-9.
BezierPatch graph(const BezierPatch& patch, std::span<const BarycentricFrame> frames,
                  GraphForm form = GraphForm::points, const Limits& limits = {});
PolynomialPatch graph(const PolynomialPatch& patch, GraphForm form = GraphForm::points,
                      const Limits& limits = {});
/// By the graphs of the rows, the last direction first.
TensorBSpline graph(const TensorBSpline& spline, GraphForm form = GraphForm::points,
                    const Limits& limits = {});

}  // namespace blossom
