#pragma once

#include <blossom/core/maps/patch_map.hpp>
#include <blossom/rational/limits.hpp>

#include <span>

namespace blossom {

/// The mixed derivative of the projected map at a point, in directions of the whole domain (see
/// `directional_derivative`), by the quotient rule.
///
/// Cost: for distinct directions with multiplicities m_1, m_2, ..., prod (m_i + 1) derivatives of the
/// polynomial map and prod C(m_i + 2, 2) products of points. Errors: `zero_weight` if the weight vanishes;
/// `limit_exceeded` if there are more products than `polarization_terms`.
Coordinates rational_derivative(const PatchMap& map, std::span<const PatchPoint> directions,
                                const PatchPoint& at, const Limits& limits = {});

/// The mixed derivative of the projected map in directions of the whole domain, as a rational map: N_k /
/// w^(k+1) with N_0 = A and N_(k+1) = N_k' w - (k + 1) N_k w', of k + 1 times the degrees of the map. A
/// direction is a vector with one argument per factor.
///
/// Cost: k products of nets per coordinate. Errors: `zero_weight` if the weight is 0 everywhere;
/// `limit_exceeded` for the degrees, if a product would have more than `limits.numbers` pairs of
/// coefficients, and if all pairs, those of order k counted k times, exceed `limits.expansion_work`. Source:
/// the quotient rule.
template <PatchRepresentation Map>
Map rational_derivative_patch(const Map& patch, std::span<const PatchPoint> directions,
                              const Limits& limits = {});

}  // namespace blossom
