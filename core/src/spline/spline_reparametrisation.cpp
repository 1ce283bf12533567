#include <blossom/core/spline/spline_reparametrisation.hpp>

#include <algorithm>
#include <vector>

namespace blossom {

BSplineCurve reparametrised(const BSplineCurve& curve, const ParameterChange& change,
                            const Limits& /*limits*/) {
    std::vector<Rational> knots;
    knots.reserve(curve.knots().size());
    for (const Rational& knot : curve.knots().knots()) knots.push_back(change(knot));
    std::vector<Coordinates> points = curve.control_points();
    if (change.slope().sign() < 0) {
        std::ranges::reverse(knots);
        std::ranges::reverse(points);
    }
    return {curve.degree(), std::move(knots), std::move(points)};
}

}  // namespace blossom
