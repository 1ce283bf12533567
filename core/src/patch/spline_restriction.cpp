#include <blossom/core/blossom/polar.hpp>
#include <blossom/core/patch/spline_restriction.hpp>
#include <blossom/core/patch/tensor_bspline_change.hpp>
#include <blossom/core/spline/de_boor.hpp>
#include <blossom/core/spline/spline_join.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <vector>

#include "tensor_rows.hpp"

namespace blossom {

namespace {

/// Numbers s from 0 to 1 between which from + s (to - from) crosses no knot.
std::vector<Rational> cuts_of_segment(const TensorBSpline& spline, std::span<const Rational> from,
                                      std::span<const Rational> to) {
    std::vector<Rational> cuts{0, 1};
    for (std::size_t d = 0; d < spline.directions(); ++d) {
        if (from[d] == to[d]) continue;
        for (const auto& [knot, multiplicity] : spline.knots(d).distinct()) {
            const Rational cut = (knot - from[d]) / (to[d] - from[d]);
            if (Rational(0) < cut && cut < Rational(1)) cuts.push_back(cut);
        }
    }
    std::ranges::sort(cuts);
    const auto repeated = std::ranges::unique(cuts);
    cuts.erase(repeated.begin(), repeated.end());
    return cuts;
}

Coordinates point_between(std::span<const Rational> from, std::span<const Rational> to, const Rational& s) {
    Coordinates point;
    for (std::size_t d = 0; d < from.size(); ++d) point.push_back(from[d] + s * (to[d] - from[d]));
    return point;
}

PatchPoint argument_in(const PlacedPatch& piece, const Coordinates& point) {
    PatchPoint argument;
    for (std::size_t d = 0; d < point.size(); ++d)
        argument.push_back(piece.frames[d].of_point(std::span(&point[d], 1)));
    return argument;
}

}  // namespace

TensorBSpline isoparametric(const TensorBSpline& spline, std::size_t direction, const Rational& parameter,
                            const Limits& limits) {
    if (spline.directions() == 1)
        throw Error(ErrorCode::wrong_arity,
                    "a map in one direction has a value, and no map, at its parameter");
    const KnotVector& knots = spline.knots(direction);
    PointGrid grid = along_rows(grid_of(spline), direction, [&](std::vector<Coordinates> points) {
        return std::vector<Coordinates>(1,
                                        de_boor(BSplineCurve(knots, std::move(points)), parameter, limits));
    });
    std::vector<KnotVector> others = spline.knots();
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(direction));
    return {std::move(others), std::move(grid.points)};
}

BSplineCurve restricted(const TensorBSpline& spline, std::span<const Rational> from,
                        std::span<const Rational> to, const Interval& interval, const Limits& limits) {
    if (interval.b() < interval.a())
        return restricted(spline, to, from, Interval(interval.b(), interval.a()), limits);
    spans_at(spline, from);
    spans_at(spline, to);
    const std::vector<Rational> cuts = cuts_of_segment(spline, from, to);
    const auto moved = [&](const Rational& s) { return interval.a() + s * (interval.b() - interval.a()); };
    std::vector<BezierCurve> pieces;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const Coordinates middle = point_between(from, to, (cuts[i] + cuts[i + 1]) / Rational(2));
        const PlacedPatch piece = placed_segment(spline, spans_at(spline, middle), limits);
        const std::vector<PatchPoint> ends{argument_in(piece, point_between(from, to, cuts[i])),
                                           argument_in(piece, point_between(from, to, cuts[i + 1]))};
        pieces.emplace_back(restricted(piece.patch, ends, limits).control_net(),
                            Interval(moved(cuts[i]), moved(cuts[i + 1])));
    }
    return join(pieces, limits);
}

}  // namespace blossom
