#include <blossom/core/curve/derivative.hpp>

#include <algorithm>

#include "maps/integer_frame.hpp"

namespace blossom {

namespace {

Coordinates multiplied(Coordinates value, const Integer& factor) {
    for (Rational& coordinate : value) coordinate *= factor;
    return value;
}

PointArray zero(std::size_t dimension) {
    return {dimension, RationalVector(std::vector<Integer>(dimension), 1)};
}

/// k! C(j, k) c_j for j = k..n.
PolynomialCurve derivative_of(const PolynomialCurve& curve, std::size_t order) {
    if (order > curve.degree()) return PolynomialCurve(zero(curve.dimension()));
    std::vector<Integer> numerators;
    for (const auto row : curve.coefficients().rows()) {
        for (std::size_t j = order; j < row.size(); ++j)
            numerators.push_back(row[j] * falling_factorial(j, order));
    }
    PointArray coefficients(curve.dimension(),
                            RationalVector(std::move(numerators), curve.coefficients().denominator()));
    coefficients.make_canonical();
    return PolynomialCurve(std::move(coefficients));
}

/// n!/(n-k)! (Delta / (b - a))^k of the control points: each level is one of de Casteljau's algorithm at
/// delta = ((b) - (a)) / (b - a).
BezierCurve derivative_of(const BezierCurve& curve, std::size_t order) {
    const std::size_t n = curve.degree();
    if (order > n) return {zero(curve.dimension()), curve.interval()};
    const auto [a, b, q] = cleared(curve.interval());
    const Integer factor = falling_factorial(n, order) * pow(q, order);
    std::vector<Integer> numerators;
    for (const auto row : curve.control_points().rows()) {
        std::vector<Integer> differences(row.begin(), row.end());
        for (std::size_t level = 0; level < order; ++level) {
            for (std::size_t i = 0; i + 1 < differences.size(); ++i) {
                differences[i] = differences[i + 1] - differences[i];
            }
            differences.pop_back();
        }
        for (const Integer& difference : differences) numerators.push_back(difference * factor);
    }
    PointArray points(
        curve.dimension(),
        RationalVector(std::move(numerators), curve.control_points().denominator() * pow(b - a, order)));
    points.make_canonical();
    return {std::move(points), curve.interval()};
}

}  // namespace

Coordinates derivative(const PolynomialMap& map, std::size_t order, const Parameter& t,
                       const Limits& limits) {
    const std::size_t n = degree_of(map);
    if (order > n) return Coordinates(dimension_of(map));
    std::vector<Argument> arguments(n, t);
    std::fill_n(arguments.begin(), order, delta);
    const auto value = [&](const auto& curve) { return blossom_value(curve, arguments, limits); };
    return multiplied(std::visit(value, map), falling_factorial(n, order));
}

PolynomialMap derivative_map(const PolynomialMap& map, std::size_t order) {
    return std::visit([&](const auto& curve) -> PolynomialMap { return derivative_of(curve, order); }, map);
}

}  // namespace blossom
