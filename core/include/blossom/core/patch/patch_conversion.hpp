#pragma once

#include <blossom/core/maps/barycentric_frame.hpp>
#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/core/maps/polynomial_patch.hpp>
#include <blossom/rational/limits.hpp>

#include <span>

namespace blossom {

/// The control net of a polynomial over a product of simplices, with one frame per factor: P_i is the blossom
/// value at i_k copies of vertex k.
///
/// The coefficients divided by multinomial coefficients are the net over the origin and the unit vectors,
/// from which `with_frame` computes the result. Errors: `mismatched_dimensions` if the dimension of a frame
/// is not that of its factor; `limit_exceeded`. Source: DeRose, section 5. Statements: derose-tri-points,
/// derose-tensor-allresults.
BezierPatch control_net(const PolynomialPatch& patch, std::span<const BarycentricFrame> frames,
                        const Limits& limits = {});

/// The monomial coefficients of a patch over a product of simplices, the inverse of `control_net`: the net
/// over the origin and the unit vectors times multinomial coefficients.
PolynomialPatch monomial_form(const BezierPatch& patch, std::span<const BarycentricFrame> frames,
                              const Limits& limits = {});

/// The polynomial q with q(x) = p(x + c), where c has the coordinates of all factors one after the other:
/// its coefficients are those of p in powers of x - c. Cost: that of a control net over c and the unit
/// vectors. Errors: `mismatched_dimensions`; `limit_exceeded`.
PolynomialPatch shifted(const PolynomialPatch& patch, std::span<const Rational> center,
                        const Limits& limits = {});

}  // namespace blossom
