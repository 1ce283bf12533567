#include <blossom/core/curve/reparametrisation.hpp>

#include <algorithm>
#include <vector>

namespace blossom {

ParameterChange::ParameterChange(const Interval& from, const Interval& to)
    : slope_((to.b() - to.a()) / (from.b() - from.a())), at_zero_(to.a() - slope_ * from.a()) {}

BezierCurve reparametrised(const BezierCurve& curve, const ParameterChange& change,
                           const Limits& /*limits*/) {
    return {curve.control_points(), change(curve.interval())};
}

TaylorCurve reparametrised(const TaylorCurve& curve, const ParameterChange& change,
                           const Limits& /*limits*/) {
    std::vector<Coordinates> coefficients = curve.coefficients.to_points();
    Rational power = 1;
    for (Coordinates& coefficient : coefficients) {
        for (Rational& coordinate : coefficient) coordinate /= power;
        power *= change.slope();
    }
    return {change(curve.center), PointArray(coefficients)};
}

PolynomialCurve reparametrised(const PolynomialCurve& curve, const ParameterChange& change,
                               const Limits& limits) {
    return monomial_form(reparametrised(TaylorCurve{0, curve.coefficients()}, change), limits);
}

BezierCurve seen_from_the_end(const BezierCurve& curve) {
    std::vector<Coordinates> points = curve.control_points().to_points();
    std::ranges::reverse(points);
    return BezierCurve(points, Interval(curve.interval().b(), curve.interval().a()));
}

BezierCurve increasing(const BezierCurve& curve) {
    return curve.interval().a() < curve.interval().b() ? curve : seen_from_the_end(curve);
}

}  // namespace blossom
