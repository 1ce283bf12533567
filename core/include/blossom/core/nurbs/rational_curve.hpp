#pragma once

#include <blossom/core/blossom/blossom.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <utility>

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

/// The mixed derivative of the projected map A / w, m_i times in direction i, from those of the polynomial
/// map (A, w): C_m = (A_m - sum over 0 < k <= m of prod C(m_i, k_i) w_k C_(m-k)) / w.
///
/// `derivative(k)` gives that of the polynomial map k_i times in direction i, with the weight last. Cost:
/// prod (m_i + 1) calls and prod C(m_i + 2, 2) products of points. Errors: `zero_weight` where the weight
/// vanishes.
Coordinates quotient_rule(std::span<const std::size_t> orders,
                          const std::function<Coordinates(std::span<const std::size_t>)>& derivative);

/// The derivative of order k of the projected map at t, by the quotient rule: C^(k) = (A^(k) - sum_{i=1..k}
/// C(k, i) w^(i) C^(k-i)) / w.
///
/// `map` has d + 1 coordinates, the result d. Cost: k + 1 blossom values and k^2 / 2 products.
/// Errors: `zero_weight` where the weight vanishes; `limit_exceeded`.
Coordinates rational_derivative(const PolynomialMap& map, std::size_t order, const Parameter& t,
                                const Limits& limits = {});

/// The derivative of order k of the projected map as a rational map again: N_k / w^(k+1) with N_0 = A and
/// N_(k+1) = N_k' w - (k + 1) N_k w', of formal degree n (k + 1), in the representation of `map`.
///
/// Cost: k products of polynomials a coordinate. Errors: `limit_exceeded` for the degree, `zero_weight` if
/// the weight is the polynomial 0. Source: the quotient rule.
PolynomialMap rational_derivative_map(const PolynomialMap& map, std::size_t order, const Limits& limits = {});

/// How smoothly two projected maps meet, see `projected_contact`.
struct ProjectedContact {
    /// The greatest k such that the derivatives of orders 0..k are equal, -1 if the values are not; none if
    /// the maps are the same.
    std::optional<std::ptrdiff_t> order;
    /// The derivatives of order k + 1, of the left and of the right map, unless they are the same.
    std::optional<std::pair<Coordinates, Coordinates>> first_difference;
};

/// The contact at s of the projected maps A/w and B/v, decided by that of the polynomial maps A v and B w:
/// their difference vanishes at s to the same order, since w v does not vanish there. It may be higher than
/// the contact of the homogeneous maps, which a factor in all coordinates changes.
///
/// Cost: products of polynomials of both degrees, and a contact of their sum. Errors: `zero_weight` where a
/// weight vanishes at s; `mismatched_dimensions`; `limit_exceeded`. Source: DeRose, theorem 2.
/// Statement: derose-thm2.
ProjectedContact projected_contact(const PolynomialMap& left, const PolynomialMap& right, const Rational& s,
                                   const Limits& limits = {});

}  // namespace blossom
