#include <blossom/core/patch/curve_along.hpp>
#include <blossom/core/patch/tensor_bspline_change.hpp>
#include <blossom/core/spline/de_boor.hpp>
#include <blossom/core/spline/knot_insertion.hpp>
#include <blossom/core/spline/spline_elevation.hpp>
#include <blossom/core/spline/spline_join.hpp>
#include <blossom/core/spline/spline_split.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <map>
#include <string>

#include "tensor_rows.hpp"

namespace blossom {

TensorBSpline elevate(const TensorBSpline& spline, std::size_t direction, std::size_t r,
                      const Limits& limits) {
    if (r == 0) return spline;
    const KnotVector& knots = spline.knots(direction);
    const std::size_t rows = spline.control_points().size() / knots.points();
    require_within(r, limits.degree, "degree", "the number of degrees to raise by", Part::by);
    require_product_within({knots.points() + r * knots.spans().size(), rows, spline.dimension()},
                           limits.numbers, "numbers", "the number of coordinates of the raised net",
                           Part::by);
    return changed_along(spline, direction,
                         [&](const BSplineCurve& rows_along) { return elevate(rows_along, r, limits); });
}

std::pair<TensorBSpline, TensorBSpline> split(const TensorBSpline& spline, std::size_t direction,
                                              const Rational& u, const Limits& limits) {
    const auto [before, behind] = split(curve_along(spline, direction), u, limits);
    return {with_curve_along(spline, direction, before), with_curve_along(spline, direction, behind)};
}

TensorBSpline restricted(const TensorBSpline& spline, std::size_t direction, const Interval& interval,
                         const Limits& limits) {
    return changed_along(spline, direction,
                         [&](const BSplineCurve& rows) { return restricted(rows, interval, limits); });
}

TensorBSpline derivative_spline(const TensorBSpline& spline, std::span<const std::size_t> orders,
                                const Limits& limits) {
    if (orders.size() != spline.directions()) {
        throw Error(ErrorCode::wrong_arity,
                    std::to_string(orders.size()) + " orders for " + std::to_string(spline.directions()) +
                        " directions",
                    Part::order);
    }
    TensorBSpline derived = spline;
    for (std::size_t d = 0; d < orders.size(); ++d) {
        if (orders[d] == 0) continue;
        derived = changed_along(
            derived, d, [&](const BSplineCurve& rows) { return derivative_curve(rows, orders[d], limits); });
    }
    return derived;
}

namespace {

/// A clamped curve over textbook knots.
BSplineCurve with_textbook_ends(const BSplineCurve& curve, const Limits& limits) {
    BSplineCurve result = clamped(curve, limits);
    if (result.knots().convention() == KnotConvention::textbook) return result;
    std::vector<Rational> knots = result.knots().knots();
    knots.insert(knots.begin(), knots.front());
    knots.push_back(knots.back());
    return {result.degree(), std::move(knots), result.control_points()};
}

void require_same_domain(const std::vector<TensorBSpline>& maps, std::size_t i, std::size_t direction) {
    const auto domain = [&](std::size_t map) {
        const Interval interval = maps[map].knots(direction).domain();
        return "[" + to_string(interval.a()) + ", " + to_string(interval.b()) + "]";
    };
    if (maps[i].knots(direction).domain() == maps.front().knots(direction).domain()) return;
    throw Error(ErrorCode::not_adjacent,
                "the domain " + domain(i) + " of map " + std::to_string(i) + " in direction " +
                    std::to_string(direction) + " is not that of map 0, " + domain(0),
                Part::maps / i);
}

/// Gives all maps the same degree and knots in one direction.
void unite_knots(std::vector<TensorBSpline>& maps, std::size_t direction, const Limits& limits) {
    std::size_t degree = 0;
    for (const TensorBSpline& map : maps) degree = std::max(degree, map.knots(direction).degree());
    std::map<Rational, std::size_t> multiplicities;
    for (TensorBSpline& map : maps) {
        map = elevate(map, direction, degree - map.knots(direction).degree(), limits);
        map = changed_along(map, direction,
                            [&](const BSplineCurve& rows) { return with_textbook_ends(rows, limits); });
        for (const auto& [knot, multiplicity] : map.knots(direction).distinct()) {
            std::size_t& greatest = multiplicities[knot];
            greatest = std::max(greatest, multiplicity);
        }
    }
    for (TensorBSpline& map : maps) {
        std::vector<Rational> missing;
        for (const auto& [knot, multiplicity] : multiplicities)
            missing.insert(missing.end(), multiplicity - map.knots(direction).multiplicity(knot), knot);
        map = insert_knots(map, direction, missing, limits);
    }
}

}  // namespace

std::vector<TensorBSpline> with_common_knots(std::vector<TensorBSpline> maps, std::size_t direction,
                                             const Limits& limits) {
    for (std::size_t i = 0; i < maps.size(); ++i) {
        if (maps[i].directions() != maps.front().directions()) {
            throw Error(ErrorCode::mismatched_dimensions,
                        "map " + std::to_string(i) + " has " + std::to_string(maps[i].directions()) +
                            " directions, map 0 has " + std::to_string(maps.front().directions()),
                        Part::maps / i);
        }
    }
    for (std::size_t d = 0; d < maps.front().directions(); ++d) {
        if (d == direction) continue;
        for (std::size_t i = 1; i < maps.size(); ++i) require_same_domain(maps, i, d);
        const bool same = std::ranges::all_of(
            maps, [&](const TensorBSpline& map) { return map.knots(d) == maps.front().knots(d); });
        if (!same) unite_knots(maps, d, limits);
    }
    return maps;
}

TensorBSpline bspline_of(const PlacedPatch& patch, const Limits& limits) {
    const NetShape& shape = patch.patch.shape();
    std::vector<KnotVector> knots;
    PointGrid grid{{}, patch.patch.control_net().to_points()};
    for (std::size_t d = 0; d < shape.factors(); ++d) {
        if (shape[d].dimension != 1) {
            throw Error(ErrorCode::mismatched_dimensions,
                        "factor " + std::to_string(d) + " of the domain has dimension " +
                            std::to_string(shape[d].dimension) + "; a B-spline is over a box");
        }
        grid.counts.push_back(shape.count(d));
    }
    for (std::size_t d = 0; d < shape.factors(); ++d) {
        const auto& ends = patch.frames[d].vertices();
        const Interval interval(ends[0][0], ends[1][0]);
        grid = along_rows(grid, d, [&](const std::vector<Coordinates>& points) {
            const BezierCurve row(points, interval);
            const BSplineCurve spline = join(std::span(&row, 1), limits);
            if (knots.size() == d) knots.push_back(spline.knots());
            return spline.control_points();
        });
    }
    return {std::move(knots), std::move(grid.points)};
}

std::vector<std::vector<std::size_t>> boxes_of(const TensorBSpline& spline, const Limits& limits) {
    std::vector<std::vector<std::size_t>> boxes{{}};
    std::size_t each = spline.dimension();
    for (std::size_t d = 0; d < spline.directions(); ++d) {
        const std::vector<std::size_t> spans = spline.knots(d).spans();
        each *= spline.knots(d).degree() + 1;
        require_product_within({boxes.size(), each, spans.size()}, limits.numbers, "numbers",
                               "the number of coordinates of the Bezier patches, at least");
        std::vector<std::vector<std::size_t>> longer;
        for (const auto& box : boxes) {
            for (const std::size_t span : spans) {
                longer.push_back(box);
                longer.back().push_back(span);
            }
        }
        boxes = std::move(longer);
    }
    return boxes;
}

PlacedPatch placed_segment(const TensorBSpline& spline, std::span<const std::size_t> spans,
                           const Limits& limits) {
    std::vector<BarycentricFrame> frames;
    BezierPatch patch = bezier_segment(spline, spans, limits);
    for (const Interval& interval : box_of(spline, spans)) {
        frames.emplace_back(std::vector<Coordinates>{{interval.a()}, {interval.b()}});
    }
    return {std::move(patch), std::move(frames)};
}

}  // namespace blossom
