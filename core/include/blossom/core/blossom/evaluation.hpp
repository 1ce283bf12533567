#pragma once

#include <blossom/core/maps/argument.hpp>
#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/polynomial_curve.hpp>
#include <blossom/rational/limits.hpp>

namespace blossom {

/// P(t) = p(t, ..., t), by Horner's rule on integers. Cost: n multiply-adds per coordinate, on numbers of n h
/// bits for t of h bits. Errors: `limit_exceeded`. Source: Goldman, axiom (iii). Statement:
/// goldman-axiom-diag.
Coordinates evaluate(const PolynomialCurve& curve, const Parameter& t, const Limits& limits = {});

/// The same from control points, by Horner's rule in the pair (t - a, b - t); t may lie outside the interval.
Coordinates evaluate(const BezierCurve& curve, const Parameter& t, const Limits& limits = {});

}  // namespace blossom
