#include <blossom/core/spline/bezier_extraction.hpp>

#include "progressive_frame.hpp"

namespace blossom {

BezierCurve sablonniere(const BSplineCurve& curve, std::size_t span, const Limits& limits) {
    const KnotVector& knots = curve.knots();
    knots.require_span(span);
    const Interval interval(knots[span], knots[span + 1]);
    if (curve.degree() == 0) return BezierCurve(curve.points_of(span), interval);
    return {ProgressiveFrame(knots.around(span), curve.points_of(span), limits).control_points(), interval};
}

std::vector<BezierCurve> bezier_segments(const BSplineCurve& curve, const Limits& limits) {
    const std::vector<std::size_t> spans = curve.knots().spans();
    require_within(spans.size() * (curve.degree() + 1) * curve.dimension(), limits.numbers, "numbers",
                   "the number of coordinates");
    std::vector<BezierCurve> segments;
    segments.reserve(spans.size());
    for (const std::size_t span : spans) segments.push_back(sablonniere(curve, span, limits));
    return segments;
}

}  // namespace blossom
