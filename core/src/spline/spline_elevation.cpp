#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/spline/bezier_extraction.hpp>
#include <blossom/core/spline/spline_elevation.hpp>

#include "spline_pieces.hpp"

namespace blossom {

BSplineCurve elevate(const BSplineCurve& curve, std::size_t r, const Limits& limits) {
    if (r == 0) return curve;
    const KnotVector& old = curve.knots();
    std::vector<BezierCurve> pieces = bezier_segments(curve, limits);
    require_within(r, limits.degree, "degree", "the number of degrees to raise by", Part::by);
    const std::size_t points = old.points() + r * pieces.size();
    require_within(points * curve.dimension(), limits.numbers, "numbers", "the number of coordinates",
                   Part::by);
    for (BezierCurve& piece : pieces) piece = elevate(piece, r, limits);

    const Interval domain = old.domain();
    std::vector<Rational> knots;
    knots.reserve(old.size() + r * (pieces.size() + 1));
    for (const auto& [knot, multiplicity] : old.distinct()) {
        const bool inside = domain.a() <= knot && knot <= domain.b();
        knots.insert(knots.end(), multiplicity + (inside ? r : 0), knot);
    }
    return spline_of_pieces({curve.degree() + r, std::move(knots), points}, pieces, limits);
}

}  // namespace blossom
