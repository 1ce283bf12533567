#pragma once

#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/worked/picture.hpp>

#include <cstddef>
#include <vector>

namespace blossom::protocol {

/// The kind of line along an edge of a grid.
using GridLine = worked::PictureFace::Edge;

/// A triangle or a quadrilateral of a grid: its corners in order, and the line from each to the next.
struct GridCell {
    std::vector<std::size_t> corners;
    std::vector<GridLine> edges;
};

/// Points on the faces of a product of simplices that have two dimensions, with the cells between them. A
/// domain of one dimension has a line of points instead.
struct DomainGrid {
    std::vector<PatchPoint> points;
    std::vector<GridCell> cells;
    std::vector<std::size_t> line;
};

/// One direction of a box that is part of a greater one.
struct BoxSide {
    std::size_t steps = 1;       ///< cells along it
    std::size_t line_every = 1;  ///< steps from one line of the picture to the next
    bool begins = true;          ///< whether the greater box begins here
    bool ends = true;            ///< whether it ends here
};

/// The grid on the faces of the greater box that lie in this one. Errors: `limit_exceeded` beyond
/// dimension 4.
DomainGrid grid_of_box(const std::vector<BoxSide>& sides);

/// The grid on all triangles of a simplex. Errors: as for a box.
DomainGrid grid_of_simplex(std::size_t dimension);

}  // namespace blossom::protocol
