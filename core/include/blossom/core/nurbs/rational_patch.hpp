#pragma once

#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/core/maps/polynomial_patch.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <functional>
#include <span>

namespace blossom {

/// The mixed derivative in k directions of the projected map A / w, from those of the polynomial map (A, w)
/// in the subsets S of the directions: C_S = (A_S - sum over non-empty T in S of w_T C_(S - T)) / w.
///
/// `derivative(subset)` gives the derivative of the polynomial map, whose last coordinate is the weight, in
/// the directions whose bits are set. Cost: 2^k calls and 3^k products of points. Errors: `zero_weight` where
/// the weight vanishes; `limit_exceeded` when 3^k exceeds `polarization_terms`.
Coordinates projected_derivative(std::size_t directions,
                                 const std::function<Coordinates(std::size_t subset)>& derivative,
                                 const Limits& limits = {});

/// The mixed derivative of the projected map in directions of the whole domain as a rational map again: N_k /
/// w^(k+1) with N_0 = A and N_(k+1) = N_k' w - (k + 1) N_k w', of k + 1 times the degrees of the map; one
/// argument a factor makes up a direction, barycentric of sum 0 for a net, x_1, ..., x_s for a polynomial.
///
/// Cost: k products of nets a coordinate. Errors: `zero_weight` if the weight is 0 everywhere;
/// `limit_exceeded` for the degrees, when a product would have more than `limits.numbers` pairs of
/// coefficients, and when all of them, those of order k counted k times, exceed `limits.expansion_work`.
/// Source: the quotient rule.
BezierPatch rational_derivative_patch(const BezierPatch& patch, std::span<const PatchPoint> directions,
                                      const Limits& limits = {});
PolynomialPatch rational_derivative_patch(const PolynomialPatch& patch,
                                          std::span<const PatchPoint> directions, const Limits& limits = {});

}  // namespace blossom
