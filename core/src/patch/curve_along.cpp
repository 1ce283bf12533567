#include <blossom/core/maps/patch_map.hpp>
#include <blossom/core/patch/curve_along.hpp>
#include <blossom/rational/error.hpp>

#include <string>
#include <vector>

#include "tensor_rows.hpp"

namespace blossom {

namespace {

void require_segment(const NetShape& shape, std::size_t direction) {
    if (direction < shape.factors() && shape[direction].dimension == 1) return;
    throw Error(ErrorCode::mismatched_dimensions,
                "factor " + std::to_string(direction) + " of the domain is not an interval");
}

/// The points of each row one after the other, as points of many dimensions.
std::vector<Coordinates> side_by_side(const PointGrid& grid, std::size_t direction) {
    std::vector<Coordinates> points(grid.counts[direction]);
    for_each_row(grid.counts, direction, [&](std::size_t begin, std::size_t step) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Coordinates& point = grid.points[begin + i * step];
            points[i].insert(points[i].end(), point.begin(), point.end());
        }
    });
    return points;
}

/// The inverse, where the number of points in the direction may be another.
PointGrid rows_of(std::vector<std::size_t> counts, std::size_t direction,
                  const std::vector<Coordinates>& points, std::size_t dimension) {
    counts[direction] = points.size();
    PointGrid grid{std::move(counts), {}};
    std::size_t size = 1;
    for (const std::size_t count : grid.counts) size *= count;
    if (points.front().size() * points.size() != size * dimension) {
        throw Error(ErrorCode::mismatched_dimensions,
                    "a curve of " + std::to_string(points.front().size()) + " coordinates cannot be " +
                        std::to_string(size / points.size()) + " rows of points with " +
                        std::to_string(dimension));
    }
    grid.points.resize(size);
    auto row = static_cast<std::ptrdiff_t>(0);
    for_each_row(grid.counts, direction, [&](std::size_t begin, std::size_t step) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto first = points[i].begin() + row;
            grid.points[begin + i * step].assign(first, first + static_cast<std::ptrdiff_t>(dimension));
        }
        row += static_cast<std::ptrdiff_t>(dimension);
    });
    return grid;
}

PointGrid grid_of(const NetShape& shape, const PointArray& points) {
    PointGrid grid{{}, points.to_points()};
    for (std::size_t f = 0; f < shape.factors(); ++f) grid.counts.push_back(shape.count(f));
    return grid;
}

template <class Patch>
Patch with_points_along(const Patch& patch, std::size_t direction, const PointArray& points) {
    require_segment(shape_of(patch), direction);
    const PointGrid grid = rows_of(grid_of(shape_of(patch), points_of(patch)).counts, direction,
                                   points.to_points(), patch.dimension());
    return {shape_of(patch).with_degree(direction, points.size() - 1), PointArray(grid.points)};
}

}  // namespace

BSplineCurve curve_along(const TensorBSpline& spline, std::size_t direction) {
    return {spline.knots(direction), side_by_side(grid_of(spline), direction)};
}

BezierCurve curve_along(const PlacedPatch& patch, std::size_t direction) {
    require_segment(patch.patch.shape(), direction);
    const auto& ends = patch.frames[direction].vertices();
    const PointGrid grid = grid_of(patch.patch.shape(), patch.patch.control_net());
    return BezierCurve(side_by_side(grid, direction), Interval(ends[0][0], ends[1][0]));
}

PolynomialCurve curve_along(const PolynomialPatch& patch, std::size_t direction) {
    require_segment(patch.shape(), direction);
    return PolynomialCurve(side_by_side(grid_of(patch.shape(), patch.coefficients()), direction));
}

TensorBSpline with_curve_along(const TensorBSpline& spline, std::size_t direction,
                               const BSplineCurve& curve) {
    std::vector<KnotVector> knots = spline.knots();
    knots[direction] = curve.knots();
    PointGrid grid = rows_of(grid_of(spline).counts, direction, curve.control_points(), spline.dimension());
    return {std::move(knots), std::move(grid.points)};
}

PlacedPatch with_curve_along(const PlacedPatch& patch, std::size_t direction, const BezierCurve& curve) {
    std::vector<BarycentricFrame> frames = patch.frames;
    BezierPatch net = with_points_along(patch.patch, direction, curve.control_points());
    frames[direction] = BarycentricFrame({{curve.interval().a()}, {curve.interval().b()}});
    return {std::move(net), std::move(frames)};
}

PolynomialPatch with_curve_along(const PolynomialPatch& patch, std::size_t direction,
                                 const PolynomialCurve& curve) {
    return with_points_along(patch, direction, curve.coefficients());
}

}  // namespace blossom
