#include <blossom/core/maps/polynomial_map.hpp>
#include <blossom/core/maps/taylor_curve.hpp>

#include "stated_points.hpp"

namespace blossom {

std::vector<StatedValue> stated_values(const PolynomialCurve& curve) {
    return stated_values(TaylorCurve{0, curve.coefficients()});
}

std::vector<StatedValue> stated_values(const BezierCurve& curve) {
    const std::vector<Coordinates> points = curve.control_points().to_points();
    const auto arguments = [&](std::size_t k) {
        return two_arguments(curve.degree(), k, Parameter(curve.interval().a()),
                             Parameter(curve.interval().b()));
    };
    return stated_points("control point", points, arguments, [](std::size_t) { return Integer(1); });
}

}  // namespace blossom
