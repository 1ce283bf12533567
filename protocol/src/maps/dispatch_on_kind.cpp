#include "dispatch_on_kind.hpp"

#include <blossom/core/blossom/inverse_formula.hpp>

namespace blossom::protocol {

BezierCurve curve_of_samples(const Samples& samples, const Limits& limits) {
    return within("map", [&] {
        return control_points_from_samples(samples.degree, samples.interval, samples.values, limits);
    });
}

PolynomialMap one_polynomial(const Map& map, const Limits& limits) {
    return dispatch_on_kind<PolynomialMap>(
        map, [&](const OnePolynomial auto& curve) { return polynomial_map(curve, limits); });
}

}  // namespace blossom::protocol
