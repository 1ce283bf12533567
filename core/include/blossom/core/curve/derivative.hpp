#pragma once

#include <blossom/core/blossom/blossom.hpp>

namespace blossom {

/// P^(k)(t) = n!/(n-k)! p(t^(n-k), delta^k); zero for k > n.
/// Cost: one blossom value. Errors: `limit_exceeded`. Source: Goldman, theorem 9. Statement: goldman-thm9.
Coordinates derivative(const PolynomialMap& map, std::size_t order, const Parameter& t,
                       const Limits& limits = {});

/// The derivative of order k as a map of formal degree n - k (0 for k >= n), in the representation of `map`:
/// coefficients, or control points n!/(n-k)! p(a^(n-k-i), b^i, delta^k) over the same interval.
/// Cost: O(n) operations, or O(n k) for control points. Source: Fernandez-Jambrina, equation (10). Statement:
/// fj-eq10.
PolynomialMap derivative_map(const PolynomialMap& map, std::size_t order);

}  // namespace blossom
