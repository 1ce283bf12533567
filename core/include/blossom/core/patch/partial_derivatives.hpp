#pragma once

#include <blossom/core/maps/patch_map.hpp>
#include <blossom/core/patch/coordinate_sums.hpp>
#include <blossom/core/patch/patch_contact.hpp>
#include <blossom/core/patch/tensor_bspline.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace blossom {

/// The map and its partial derivatives with respect to the coordinates of the domain: P, dP/dx_1, ...,
/// dP/dx_s. A net has the coordinates of its frames. Cost and errors: those of
/// `directional_derivative_patch`.
std::vector<PolynomialPatch> with_partial_derivatives(const PolynomialPatch& patch,
                                                      const Limits& limits = {});
std::vector<BezierPatch> with_partial_derivatives(const BezierPatch& patch,
                                                  std::span<const BarycentricFrame> frames,
                                                  const Limits& limits = {});
std::vector<TensorBSpline> with_partial_derivatives(const TensorBSpline& spline, const Limits& limits = {});

// Polynomials in the coordinates of such a list of maps, see `combined`. A rational map is (A, w) with its
// derivatives (A_i, w_i), and the result is rational too, with the weight last.

/// The partial derivative i = 1, ..., s of the map; of a rational one (A_i w - A w_i) / w^2. `dimension` is
/// that of the points, without a weight.
CoordinateSums partial_derivative(std::size_t i, std::size_t dimension, bool rational);

/// The determinant of the partial derivatives of a map from dimension n to dimension n; of a rational one
/// (-1)^n det((A, w), (A_1, w_1), ..., (A_n, w_n)) / w^(n + 1). Errors: as for `determinant`.
CoordinateSums jacobian_determinant(std::size_t dimension, bool rational, const Limits& limits = {});

/// The cross product of the partial derivatives of a map from dimension n - 1 to dimension n, which is normal
/// to it; of a rational one the first n coordinates of (-1)^(n + 1) (A, w) x (A_1, w_1) x ..., divided by
/// w^n. Errors: as for `cross_product`.
CoordinateSums normal_vector(std::size_t dimension, bool rational, const Limits& limits = {});

}  // namespace blossom
