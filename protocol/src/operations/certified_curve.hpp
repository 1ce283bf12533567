#pragma once

#include <blossom/core/spline/progressive.hpp>

#include <optional>
#include <variant>
#include <vector>

#include "certificates/certificate.hpp"
#include "maps/map.hpp"

/// What a map that is given says in the terms of a certificate: blossom values of one polynomial.

namespace blossom::protocol {

/// What the numbers of a map say about the blossom p of degree n of the map of which it is the derivative of
/// that order, m = n - order. Bezier curves: P_k = n!/m! p(a^(m-k), b^k, delta^order). Progressive curves:
/// P_k = n!/m! p(t_k, ..., t_(k+m-1), delta^order). Taylor forms, polynomials about 0: c_k = n!/m! C(m, k)
/// p(a^(m-k), delta^(order+k)). Source: Goldman, theorems 4 and 9, equation 4.4; DeRose, section 4.6.
struct StatedValues {
    std::size_t degree;
    std::size_t order;

    std::vector<CertifiedValue> operator()(const BezierCurve& curve) const;
    std::vector<CertifiedValue> operator()(const ProgressiveCurve& curve) const;
    std::vector<CertifiedValue> operator()(const TaylorCurve& curve) const;
    std::vector<CertifiedValue> operator()(const PolynomialCurve& curve) const;
    /// Of every other representation: what the one to which it is converted says.
    std::vector<CertifiedValue> operator()(const OnePolynomial auto& curve) const {
        return std::visit(*this, polynomial_map(curve));
    }
};

/// The polynomial of a map, of a B-spline that on one span, with the claims that its points are the given
/// ones: they determine it. Monomial coefficients need no claim.
/// Errors: `wrong_kind` for samples and patches; `outside_domain`, `limit_exceeded`.
CertifiedMap certified_map(const Map& map, std::optional<std::size_t> span, const Limits& limits);

}  // namespace blossom::protocol
