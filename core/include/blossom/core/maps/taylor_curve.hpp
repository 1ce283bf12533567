#pragma once

#include <blossom/core/maps/polynomial_curve.hpp>
#include <blossom/rational/limits.hpp>

namespace blossom {

/// A polynomial map by its Taylor coefficients at a centre: P(t) = sum_k m_k (t - center)^k, n + 1 of them.
struct TaylorCurve {
    Rational center;
    PointArray coefficients;

    friend bool operator==(const TaylorCurve&, const TaylorCurve&) = default;
};

/// m_k = P^(k)(center) / k! = C(n, k) p(center^(n-k), delta^k); the formal degree is kept.
/// Cost: n^2 multiply-adds a coordinate. Errors: `limit_exceeded`.
/// Source: Goldman, exercise 10b. Statements: goldman-ex-10b, goldman-thm7.
TaylorCurve taylor_form(const PolynomialCurve& curve, const Rational& center, const Limits& limits = {});

/// The monomial coefficients at 0, the inverse of `taylor_form`.
PolynomialCurve monomial_form(const TaylorCurve& curve, const Limits& limits = {});

}  // namespace blossom
