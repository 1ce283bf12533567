#pragma once

#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/polynomial_curve.hpp>
#include <blossom/rational/limits.hpp>

#include <concepts>
#include <cstddef>
#include <optional>
#include <variant>

namespace blossom {

/// A curve that is one polynomial, in one of the two representations that every algorithm takes.
using PolynomialMap = std::variant<PolynomialCurve, BezierCurve>;

inline PolynomialMap polynomial_map(const PolynomialCurve& curve, const Limits& = {}) { return curve; }
inline PolynomialMap polynomial_map(const BezierCurve& curve, const Limits& = {}) { return curve; }

/// The interval that a curve brings with it; none where it has no such interval.
inline std::optional<Interval> own_interval(const PolynomialCurve&) { return std::nullopt; }
inline std::optional<Interval> own_interval(const BezierCurve& curve) { return curve.interval(); }

/// A representation of a curve that is one polynomial: it knows its formal degree, its dimension, its own
/// interval and how it is converted to a `PolynomialMap`. Everything that is done with one polynomial, from
/// evaluation to degree reduction, follows from these four.
template <class Curve>
concept OnePolynomial = requires(const Curve& curve, const Limits& limits) {
    { curve.degree() } -> std::same_as<std::size_t>;
    { curve.dimension() } -> std::same_as<std::size_t>;
    { own_interval(curve) } -> std::same_as<std::optional<Interval>>;
    { polynomial_map(curve, limits) } -> std::same_as<PolynomialMap>;
};

/// The own interval of a curve, and [0, 1] where it has none.
Interval interval_of(const auto& curve) { return own_interval(curve).value_or(Interval()); }

}  // namespace blossom
