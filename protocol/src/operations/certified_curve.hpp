#pragma once

#include <blossom/core/maps/stated_value.hpp>

#include <optional>
#include <vector>

#include "certificates/certificate.hpp"
#include "maps/map.hpp"

/// What a map that is given says in the terms of a certificate: blossom values of one polynomial.

namespace blossom::protocol {

/// What the points of a map, which is the derivative of some order of a map of a formal degree n, say about
/// the blossom p of that map: point = multiple n!/(n-order)! p(arguments, delta^order), where multiple and
/// arguments are those of the `stated_values`. Source: Goldman, theorem 9.
std::vector<CertifiedValue> claims(std::vector<StatedValue> stated, std::size_t degree, std::size_t order);

/// The polynomial of a map, of a B-spline that on one span, with the claims that its points are the given
/// ones: they determine it. Monomial coefficients need no claim.
/// Errors: `wrong_kind` for samples and patches; `outside_domain`, `limit_exceeded`.
CertifiedMap certified_map(const Map& map, std::optional<std::size_t> span, const Limits& limits);

}  // namespace blossom::protocol
