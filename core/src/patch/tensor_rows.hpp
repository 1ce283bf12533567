#pragma once

#include <blossom/core/maps/bspline_curve.hpp>
#include <blossom/core/patch/tensor_bspline.hpp>

#include <cstddef>
#include <utility>
#include <vector>

/// Rows of control points in a box.

namespace blossom {

/// Points in a box; the index of the last direction changes fastest.
struct PointGrid {
    std::vector<std::size_t> counts;
    std::vector<Coordinates> points;
};

inline PointGrid grid_of(const TensorBSpline& spline) {
    PointGrid grid{{}, spline.control_points()};
    for (const KnotVector& knots : spline.knots()) grid.counts.push_back(knots.points());
    return grid;
}

/// The grid in which the points of every row in one direction are replaced by those of `row`, which may be
/// more or fewer.
template <class Row>
PointGrid along_rows(const PointGrid& grid, std::size_t direction, const Row& row) {
    std::size_t behind = 1;
    for (std::size_t d = direction + 1; d < grid.counts.size(); ++d) behind *= grid.counts[d];
    const std::size_t count = grid.counts[direction];
    PointGrid result{grid.counts, {}};
    for (std::size_t block = 0; block < grid.points.size(); block += count * behind) {
        std::vector<std::vector<Coordinates>> rows;
        for (std::size_t k = 0; k < behind; ++k) {
            std::vector<Coordinates> points;
            points.reserve(count);
            for (std::size_t i = 0; i < count; ++i) points.push_back(grid.points[block + i * behind + k]);
            rows.push_back(row(std::move(points)));
        }
        result.counts[direction] = rows.front().size();
        for (std::size_t i = 0; i < rows.front().size(); ++i) {
            for (auto& made : rows) result.points.push_back(std::move(made[i]));
        }
    }
    return result;
}

/// Replaces every row in one direction, which is a spline curve, by change(row). The knots of the result
/// depend only on the knots of the row.
template <class Change>
TensorBSpline with_rows(const TensorBSpline& spline, std::size_t direction, const Change& change) {
    std::vector<KnotVector> knots = spline.knots();
    PointGrid grid = along_rows(grid_of(spline), direction, [&](std::vector<Coordinates> points) {
        const BSplineCurve changed = change(BSplineCurve(spline.knots(direction), std::move(points)));
        knots[direction] = changed.knots();
        return changed.control_points();
    });
    return {std::move(knots), std::move(grid.points)};
}

}  // namespace blossom
