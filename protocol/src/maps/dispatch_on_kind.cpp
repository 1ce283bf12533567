#include "dispatch_on_kind.hpp"

#include <blossom/core/blossom/conversion.hpp>
#include <blossom/core/curve/inverse_formula.hpp>

namespace blossom::protocol {

PolynomialMap polynomial_map(const TaylorCurve& curve, const Limits& limits) {
    return monomial_form(curve, limits);
}

PolynomialMap polynomial_map(const ProgressiveCurve& curve, const Limits& limits) {
    return control_points(curve, own_interval(curve), limits);
}

PolynomialCurve monomial_curve(const PolynomialMap& map, const Limits& limits) {
    if (const auto* curve = std::get_if<PolynomialCurve>(&map)) return *curve;
    return monomial_form(std::get<BezierCurve>(map), limits);
}

std::vector<Polynomial> coordinates_of(const PolynomialCurve& curve) {
    std::vector<Polynomial> coordinates;
    coordinates.reserve(curve.dimension());
    for (std::size_t j = 0; j < curve.dimension(); ++j) coordinates.push_back(curve.coordinate(j));
    return coordinates;
}

Interval own_interval(const ProgressiveCurve& curve) {
    const std::size_t n = curve.degree();
    // The two knots in the middle always differ, or there would be no such curve.
    return n == 0 ? Interval() : Interval(curve.knots()[n - 1], curve.knots()[n]);
}

BezierCurve curve_of_samples(const Samples& samples, const Limits& limits) {
    return within("map", [&] {
        return control_points_from_samples(samples.degree, samples.interval, samples.values, limits);
    });
}

PolynomialMap one_polynomial(const Map& map, const Limits& limits) {
    return serve<PolynomialMap>(
        map, [&](const OnePolynomial auto& curve) { return polynomial_map(curve, limits); });
}

}  // namespace blossom::protocol
