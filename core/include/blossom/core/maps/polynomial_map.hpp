#pragma once

#include <blossom/core/maps/bezier_curve.hpp>
#include <blossom/core/maps/on_simplices.hpp>
#include <blossom/core/maps/polynomial_curve.hpp>
#include <blossom/core/maps/stated_value.hpp>
#include <blossom/rational/limits.hpp>

#include <concepts>
#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

namespace blossom {

/// A polynomial curve in one of the two representations that every algorithm takes.
using PolynomialMap = std::variant<PolynomialCurve, BezierCurve>;

inline std::size_t degree_of(const PolynomialMap& map) {
    return std::visit([](const auto& curve) { return curve.degree(); }, map);
}
inline std::size_t dimension_of(const PolynomialMap& map) {
    return std::visit([](const auto& curve) { return curve.dimension(); }, map);
}

/// The shape of a curve is one segment.
inline NetShape shape_of(const PolynomialCurve& curve) { return NetShape::segment(curve.degree()); }
inline NetShape shape_of(const BezierCurve& curve) { return NetShape::segment(curve.degree()); }
inline const PointArray& points_of(const PolynomialCurve& curve) { return curve.coefficients(); }
inline const PointArray& points_of(const BezierCurve& curve) { return curve.control_points(); }

inline PolynomialMap polynomial_map(const PolynomialCurve& curve, const Limits& = {}) { return curve; }
inline PolynomialMap polynomial_map(const BezierCurve& curve, const Limits& = {}) { return curve; }

/// The interval of a curve that has one; otherwise nullopt.
inline std::optional<Interval> own_interval(const PolynomialCurve&) { return std::nullopt; }
inline std::optional<Interval> own_interval(const BezierCurve& curve) { return curve.interval(); }

/// The points of a representation as values of the blossom p of formal degree n. Coefficients: C(n, k)
/// p(0^(n-k), delta^k). Control points: p(a^(n-k), b^k). Source: Goldman, theorem 4 and equation (4.4).
/// Statements: goldman-thm4, goldman-eq44.
std::vector<StatedValue> stated_values(const PolynomialCurve& curve);
std::vector<StatedValue> stated_values(const BezierCurve& curve);

/// A representation of a polynomial curve. It has a formal degree, a dimension, an optional interval, its
/// points as values of the blossom, and a conversion to `PolynomialMap`. All operations on polynomial curves,
/// from evaluation to degree reduction, use only these.
template <class Curve>
concept OnePolynomial = requires(const Curve& curve, const Limits& limits) {
    { curve.degree() } -> std::same_as<std::size_t>;
    { curve.dimension() } -> std::same_as<std::size_t>;
    { own_interval(curve) } -> std::same_as<std::optional<Interval>>;
    { stated_values(curve) } -> std::same_as<std::vector<StatedValue>>;
    { polynomial_map(curve, limits) } -> std::same_as<PolynomialMap>;
};

/// The interval of a curve, or [0, 1] if it has none.
Interval interval_of(const auto& curve) { return own_interval(curve).value_or(Interval()); }

}  // namespace blossom
