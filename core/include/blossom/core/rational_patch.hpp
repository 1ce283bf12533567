#pragma once

#include <blossom/core/point_array.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <functional>

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

}  // namespace blossom
