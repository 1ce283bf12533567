#include "spline_pieces.hpp"

#include <blossom/core/blossom/blossom.hpp>

#include <algorithm>
#include <optional>

namespace blossom {

namespace {

/// The beginning of the influence of a control point within the domain: its spans reach from the knot before
/// its window to the knot behind it. An end of the domain if there is no such knot.
const Rational& beginning_of_influence(const KnotVector& knots, std::size_t point) {
    const std::size_t window = knots.window_index(point);
    return knots[std::clamp(window - std::min<std::size_t>(window, 1), knots.begin_index(),
                            knots.end_index())];
}

}  // namespace

BSplineCurve spline_of_pieces(KnotVector knots, std::span<const BezierCurve> pieces, const Limits& limits) {
    std::vector<Coordinates> points;
    points.reserve(knots.points());
    std::optional<Blossom> blossom;
    std::size_t piece = pieces.size();
    for (std::size_t j = 0; j < knots.points(); ++j) {
        const Rational& begin = beginning_of_influence(knots, j);
        const auto behind = std::ranges::upper_bound(
            pieces, begin, {}, [](const BezierCurve& curve) { return curve.interval().a(); });
        const auto found = static_cast<std::size_t>(behind - pieces.begin()) - 1;
        if (found != piece) {
            piece = found;
            blossom.emplace(pieces[piece], limits);
        }
        const auto window = knots.window(j);
        points.push_back((*blossom)(std::vector<Argument>(window.begin(), window.end())));
    }
    return {std::move(knots), std::move(points)};
}

}  // namespace blossom
