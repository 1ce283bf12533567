#include <blossom/core/nurbs/rational_spline.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/continuity.hpp>
#include <blossom/core/spline/de_boor.hpp>
#include <blossom/core/spline/spline_join.hpp>

#include <variant>
#include <vector>

namespace blossom {

Coordinates rational_derivative(const BSplineCurve& curve, std::size_t order, const Parameter& t,
                                const Limits& limits) {
    return quotient_rule(std::span(&order, 1),
                         [&](std::span<const std::size_t> k) { return derivative(curve, k[0], t, limits); });
}

BSplineCurve rational_derivative_curve(const BSplineCurve& curve, std::size_t order, const Limits& limits) {
    std::vector<BezierCurve> segments = bezier_segments(curve, limits);
    for (BezierCurve& segment : segments) {
        segment = std::get<BezierCurve>(rational_derivative_map(segment, order, limits));
    }
    return join(segments, limits);
}

ProjectedContact projected_contact(const BSplineCurve& curve, const Rational& s, const Limits& limits) {
    const auto [before, behind] = sides(curve.knots(), s);
    if (before == behind) return {};
    return projected_contact(sablonniere(curve, before, limits), sablonniere(curve, behind, limits), s,
                             limits);
}

}  // namespace blossom
