#pragma once

#include <blossom/core/maps/polynomial_map.hpp>
#include <blossom/rational/limits.hpp>

#include <string>

namespace blossom {

/// A polynomial map by its n + 1 Taylor coefficients at a centre: P(t) = sum_k m_k (t - center)^k.
struct TaylorCurve {
    Rational center;
    PointArray coefficients;

    std::size_t degree() const { return coefficients.size() - 1; }
    std::size_t dimension() const { return coefficients.dimension(); }

    friend bool operator==(const TaylorCurve&, const TaylorCurve&) = default;
    /// "Taylor coefficients (1), (2) at 1/2".
    friend std::string to_string(const TaylorCurve& curve);
    friend std::size_t hash_value(const TaylorCurve& curve) {
        return hash_of(curve.center, curve.coefficients);
    }
};

/// m_k = P^(k)(center) / k! = C(n, k) p(center^(n-k), delta^k); the formal degree is kept.
/// Cost: n^2 multiply-adds per coordinate. Errors: `limit_exceeded`.
/// Source: Goldman, exercise 10b. Statements: goldman-ex-10b, goldman-thm7.
TaylorCurve taylor_form(const PolynomialCurve& curve, const Rational& center, const Limits& limits = {});

/// The monomial coefficients at 0: the inverse of `taylor_form`.
PolynomialCurve monomial_form(const TaylorCurve& curve, const Limits& limits = {});

/// The polynomial map, by `monomial_form`; it has no interval.
inline PolynomialMap polynomial_map(const TaylorCurve& curve, const Limits& limits = {}) {
    return monomial_form(curve, limits);
}
inline std::optional<Interval> own_interval(const TaylorCurve&) { return std::nullopt; }
/// m_k = C(n, k) p(center^(n-k), delta^k).
std::vector<StatedValue> stated_values(const TaylorCurve& curve);

}  // namespace blossom
