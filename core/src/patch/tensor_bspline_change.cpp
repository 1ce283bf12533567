#include <blossom/core/patch/tensor_bspline_change.hpp>
#include <blossom/core/spline/de_boor.hpp>
#include <blossom/core/spline/spline_elevation.hpp>
#include <blossom/core/spline/spline_join.hpp>
#include <blossom/core/spline/spline_split.hpp>
#include <blossom/rational/error.hpp>

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
    return with_rows(spline, direction, [&](const BSplineCurve& row) { return elevate(row, r, limits); });
}

std::pair<TensorBSpline, TensorBSpline> split(const TensorBSpline& spline, std::size_t direction,
                                              const Rational& u, const Limits& limits) {
    return {
        with_rows(spline, direction, [&](const BSplineCurve& row) { return split(row, u, limits).first; }),
        with_rows(spline, direction, [&](const BSplineCurve& row) { return split(row, u, limits).second; })};
}

TensorBSpline restricted(const TensorBSpline& spline, std::size_t direction, const Interval& interval,
                         const Limits& limits) {
    return with_rows(spline, direction,
                     [&](const BSplineCurve& row) { return restricted(row, interval, limits); });
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
        derived = with_rows(
            derived, d, [&](const BSplineCurve& row) { return derivative_curve(row, orders[d], limits); });
    }
    return derived;
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
