#pragma once

#include <blossom/core/blossom/blossom.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <utility>

namespace blossom {

// A rational (NURBS) map into Q^d is a polynomial map into Q^(d+1) whose last coordinate is the weight: a
// point P with weight w is stored as (w P, w), and (x, 0) is a point at infinity. Every operation on maps
// works on rational maps; the functions here involve the projection.

/// (x_1, ..., x_d, w) projected to (x_1 / w, ..., x_d / w). Errors: `zero_weight`; `mismatched_dimensions` if
/// there is no coordinate.
Coordinates projected(const Coordinates& homogeneous);

/// The homogeneous coordinates (w x_1, ..., w x_d, w) of a Euclidean point with a weight. Errors:
/// `zero_weight`.
Coordinates homogeneous_point(const Coordinates& point, const Rational& weight);

/// The mixed derivative of the projected map A / w, of order m_i in direction i, from the derivatives of the
/// polynomial map (A, w): C_m = (A_m - sum over 0 < k <= m of prod C(m_i, k_i) w_k C_(m-k)) / w.
///
/// `derivative(k)` gives the derivative of the polynomial map of order k_i in direction i, with the weight
/// last. Cost: prod (m_i + 1) calls and prod C(m_i + 2, 2) products of points. Errors: `zero_weight` if the
/// weight vanishes.
Coordinates quotient_rule(std::span<const std::size_t> orders,
                          const std::function<Coordinates(std::span<const std::size_t>)>& derivative);

/// The derivative of order k of the projected map at t, by the quotient rule: C^(k) = (A^(k) - sum_{i=1..k}
/// C(k, i) w^(i) C^(k-i)) / w.
///
/// `map` has d + 1 coordinates, the result has d. Cost: k + 1 blossom values and k^2 / 2 products.
/// Errors: `zero_weight` if the weight vanishes at t; `limit_exceeded`.
Coordinates rational_derivative(const PolynomialMap& map, std::size_t order, const Parameter& t,
                                const Limits& limits = {});

/// The derivative of order k of the projected map as a rational map: N_k / w^(k+1) with N_0 = A and N_(k+1) =
/// N_k' w - (k + 1) N_k w', of formal degree n (k + 1), in the representation of `map`.
///
/// Cost: k products of polynomials per coordinate. Errors: `limit_exceeded` for the degree, `zero_weight` if
/// the weight is the zero polynomial. Source: the quotient rule.
PolynomialMap rational_derivative_map(const PolynomialMap& map, std::size_t order, const Limits& limits = {});

/// How smoothly two projected maps meet, see `projected_contact`.
struct ProjectedContact {
    /// The greatest k such that the derivatives of orders 0..k are equal; -1 if the values differ, nullopt if
    /// the maps are equal.
    std::optional<std::ptrdiff_t> order;
    /// The derivatives of order k + 1 of the left and of the right map, unless the maps are equal.
    std::optional<std::pair<Coordinates, Coordinates>> first_difference;
};

/// The contact at s of the projected maps A/w and B/v. It is the contact of the polynomial maps A v and B w:
/// their difference vanishes at s to the same order, since w v does not vanish there. It can be higher than
/// the contact of the homogeneous maps, which depends on a common factor of the coordinates.
///
/// Cost: products of polynomials of both degrees, and a contact in the sum of the degrees. Errors:
/// `zero_weight` if a weight vanishes at s; `mismatched_dimensions`; `limit_exceeded`. Source: DeRose,
/// theorem 2. Statement: derose-thm2.
ProjectedContact projected_contact(const PolynomialMap& left, const PolynomialMap& right, const Rational& s,
                                   const Limits& limits = {});

}  // namespace blossom
