#pragma once

#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/rational/limits.hpp>

#include <span>
#include <vector>

namespace blossom {

/// The blossom of a patch, symmetric and linear in the arguments of each factor, with the map on the
/// diagonal.
///
/// In each factor the coefficients of prod_j sum_k argument_jk X_k are the weights of the control points.
/// Cost: one multiply-add a control point and coordinate; for the weights at most (s + 1) C(n + s, s + 1)
/// multiply-adds a factor, less where arguments repeat. Errors: those of `require_arguments`;
/// `limit_exceeded`. Source: DeRose, sections 5 and 6; Fernandez-Jambrina, equation (9). Statements:
/// derose-tensor-props, derose-thm3, derose-adt-blossom, fj-eq9, fj-tri-blossom.
Coordinates blossom_value(const BezierPatch& patch, const PatchArguments& arguments,
                          const Limits& limits = {});

/// The values at barycentric points, by Bernstein polynomials.
///
/// Cost: s multiplications a control point for each point, and one multiply-add a control point and
/// coordinate. Errors: `not_affine` unless the coordinates in each factor have the sum 1, `wrong_arity`,
/// `mismatched_dimensions`, with places below `Part::at / i`; `limit_exceeded`. Statements: fj-tri-def,
/// fj-tensor-matrix.
std::vector<Coordinates> evaluate(const BezierPatch& patch, std::span<const PatchPoint> points,
                                  const Limits& limits = {});
Coordinates evaluate(const BezierPatch& patch, const PatchPoint& point, const Limits& limits = {});

/// The mixed derivative in k_f directions of each factor f, barycentric vectors with coordinates of sum 0:
/// prod n_f! / (n_f - k_f)! times the blossom at n_f - k_f copies of the point and the directions; zero where
/// k_f > n_f.
///
/// Cost: one blossom value. Errors: `not_affine` for a direction whose sum is not 0 or a point whose sum is
/// not 1; `wrong_arity`, `mismatched_dimensions`, `limit_exceeded`. Source: Goldman, theorem 9, in each
/// factor.
Coordinates derivative(const BezierPatch& patch, const PatchArguments& directions, const PatchPoint& at,
                       const Limits& limits = {});

/// The same derivative as a patch, of degree n_f - k_f in each factor: one step of de Casteljau a direction.
/// Where k_f > n_f it is zero of degree 0 in every factor. Errors: as for `derivative`.
BezierPatch derivative_patch(const BezierPatch& patch, const PatchArguments& directions,
                             const Limits& limits = {});

}  // namespace blossom
