#pragma once

// Rational curves by homogeneous points, which any number may multiply.

#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <optional>

namespace blossom {

/// How two pieces meet once the right one is multiplied by the number with which they meet best.
struct ScaledContact {
    std::optional<Rational> factor;  ///< none if they do not meet
    bool is_infinite = false;
};

/// Of curves that meet at the beginning of the right one.
ScaledContact scaled_contact(const BezierCurve& left, const BezierCurve& right, const Limits& limits);

/// The curve with all coordinates multiplied by a number.
BezierCurve scaled(const BezierCurve& curve, const Rational& factor);

}  // namespace blossom
