#pragma once

#include <blossom/core/maps/stated_value.hpp>

#include <optional>
#include <vector>

#include "certificates/certificate.hpp"
#include "maps/map.hpp"

/// The given map as certificates state it: as blossom values of one polynomial.

namespace blossom::protocol {

/// The points of a derivative of some order of a map of formal degree n as values of
/// the blossom p of that map: point = multiple n!/(n-order)! p(arguments, delta^order), where multiple and
/// arguments are those of the `stated_values`. Source: Goldman, theorem 9.
std::vector<CertifiedValue> claims(std::vector<StatedValue> stated, std::size_t degree, std::size_t order);

/// The curve along a direction of a tensor product, see `curve_along`, likewise.
CertifiedMap certified_direction(const Patch& patch, std::size_t direction, const Limits& limits);

/// The polynomial of a map, or of one span of a B-spline, with the claims that its points are the given
/// ones: they determine it. Monomial coefficients need no claim.
/// Errors: `wrong_kind` for samples and patches; `outside_domain`, `limit_exceeded`.
CertifiedMap certified_map(const Map& map, std::optional<std::size_t> span, const Limits& limits);

}  // namespace blossom::protocol
