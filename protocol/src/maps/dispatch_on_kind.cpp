#include "dispatch_on_kind.hpp"

#include <blossom/core/blossom/inverse_formula.hpp>
#include <blossom/core/curve/interpolation.hpp>

namespace blossom::protocol {

namespace {

BezierCurve interpolating_curve(const Samples& samples, const Limits& limits) {
    std::vector<Rational> nodes;
    std::vector<Coordinates> values;
    for (const auto& [node, value] : samples.values) {
        nodes.push_back(node);
        values.push_back(value);
    }
    return control_points(interpolate(nodes, values, limits), samples.interval, limits);
}

}  // namespace

BezierCurve curve_of_samples(const Samples& samples, const Limits& limits) {
    return within("map", [&] {
        if (samples.values.size() == samples.degree + 1) return interpolating_curve(samples, limits);
        return control_points_from_samples(samples.degree, samples.interval, samples.values, limits);
    });
}

PolynomialMap one_polynomial(const Map& map, const Limits& limits) {
    return dispatch_on_kind<PolynomialMap>(
        map, [&](const OnePolynomial auto& curve) { return polynomial_map(curve, limits); });
}

}  // namespace blossom::protocol
