#pragma once

// The oracle for the representations: a curve as polynomials, by the definition of its representation and
// ring operations only.

#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/polynomial_curve.hpp>
#include <blossom/core/maps/taylor_curve.hpp>

#include <vector>

namespace blossom::testing {

/// sum_k P_k C(n, k) (b - t)^(n-k) (t - a)^k / (b - a)^n, one polynomial per coordinate.
std::vector<Polynomial> expanded(const BezierCurve& curve);
std::vector<Polynomial> expanded(const PolynomialCurve& curve);
/// sum_k m_k (t - center)^k.
std::vector<Polynomial> expanded(const TaylorCurve& curve);

/// The integral over [a, b], from the coefficients; it changes its sign if the interval is reversed.
Rational integral(const Polynomial& polynomial, const Interval& interval = {});

}  // namespace blossom::testing
