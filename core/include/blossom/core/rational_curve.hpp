#pragma once

#include <blossom/core/blossom.hpp>

namespace blossom {

// A rational (NURBS) map into Q^d is a polynomial map into Q^(d+1) whose last coordinate is the weight: a
// point P with weight w stands there as (w P, w), and (x, 0) is a point at infinity. Every operation on maps
// serves rational ones; what is particular to them is the projection.

/// (x_1, ..., x_d, w) as (x_1 / w, ..., x_d / w). Errors: `zero_weight`; `mismatched_dimensions` without a
/// coordinate.
Coordinates projected(const Coordinates& homogeneous);

/// The Euclidean point with its weight as homogeneous coordinates (w x_1, ..., w x_d, w). Errors:
/// `zero_weight`.
Coordinates homogeneous_point(const Coordinates& point, const Rational& weight);

/// The derivative of order k of the projected map at t, from those of numerators A and weight w by the
/// quotient rule C^(k) = (A^(k) - sum_{i=1..k} C(k, i) w^(i) C^(k-i)) / w.
///
/// `map` has d + 1 coordinates, the result d. Cost: k + 1 blossom values and k^2 / 2 products.
/// Errors: `zero_weight` where the weight vanishes; `limit_exceeded`.
Coordinates rational_derivative(const PolynomialMap& map, std::size_t order, const Parameter& t,
                                const Limits& limits = {});

}  // namespace blossom
