#include <blossom/core/nurbs/rational_spline.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/continuity.hpp>
#include <blossom/core/spline/de_boor.hpp>
#include <blossom/core/spline/periodic_spline.hpp>
#include <blossom/core/spline/spline_join.hpp>

#include <variant>
#include <vector>

#include "scaled_contact.hpp"

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

ProjectedContact projected_seam_contact(const BSplineCurve& curve, const Limits& limits) {
    const auto [left, right] = sides_of_seam(curve, limits);
    return projected_contact(left, right, right.interval().a(), limits);
}

std::size_t rational_seam_multiplicity(const BSplineCurve& curve, const Limits& limits) {
    const auto [left, right] = sides_of_seam(curve, limits);
    const Rational factor = scaled_contact(left, right, limits).factor.value_or(1);
    const Rational& seam = right.interval().a();
    return seam_multiplicity(curve.degree(), contact(left, scaled(right, factor), seam, limits), seam);
}

}  // namespace blossom
