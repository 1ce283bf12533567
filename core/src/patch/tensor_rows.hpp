#pragma once

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

/// action(begin, step) for every row in one direction: its points are begin, begin + step, ...
template <class Action>
void for_each_row(const std::vector<std::size_t>& counts, std::size_t direction, const Action& action) {
    std::size_t size = 1;
    std::size_t behind = 1;
    for (std::size_t d = 0; d < counts.size(); ++d) {
        size *= counts[d];
        if (d > direction) behind *= counts[d];
    }
    for (std::size_t block = 0; block < size; block += counts[direction] * behind) {
        for (std::size_t k = 0; k < behind; ++k) action(block + k, behind);
    }
}

/// The grid in which the points of every row in one direction are replaced by those of `row`, which may be
/// more or fewer.
template <class Row>
PointGrid along_rows(const PointGrid& grid, std::size_t direction, const Row& row) {
    std::vector<std::vector<Coordinates>> rows;
    for_each_row(grid.counts, direction, [&](std::size_t begin, std::size_t step) {
        std::vector<Coordinates> points;
        points.reserve(grid.counts[direction]);
        for (std::size_t i = 0; i < grid.counts[direction]; ++i)
            points.push_back(grid.points[begin + i * step]);
        rows.push_back(row(std::move(points)));
    });
    PointGrid result{grid.counts, {}};
    result.counts[direction] = rows.front().size();
    result.points.resize(rows.size() * rows.front().size());
    auto made = rows.begin();
    for_each_row(result.counts, direction, [&](std::size_t begin, std::size_t step) {
        for (std::size_t i = 0; i < made->size(); ++i)
            result.points[begin + i * step] = std::move((*made)[i]);
        ++made;
    });
    return result;
}

}  // namespace blossom
