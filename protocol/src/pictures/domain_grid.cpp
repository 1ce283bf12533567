#include "domain_grid.hpp"

#include <blossom/rational/error.hpp>

#include <array>
#include <string>

namespace blossom::protocol {

namespace {

constexpr std::size_t most_dimensions = 4;
constexpr std::size_t steps_of_simplex = 16;
constexpr std::size_t steps_a_line = 2;

void require_few_dimensions(std::size_t dimension) {
    if (dimension <= most_dimensions) return;
    throw Error(ErrorCode::limit_exceeded,
                "a domain of dimension " + std::to_string(dimension) +
                    " has too many faces to be shown; they are shown up to dimension " +
                    std::to_string(most_dimensions),
                Place{"map"});
}

Coordinates on_segment(std::size_t i, std::size_t steps) {
    return {Rational(steps - i, steps), Rational(i, steps)};
}

/// The line along step i of a side.
GridLine line_at(const BoxSide& side, std::size_t i) {
    if ((i == 0 && side.begins) || (i == side.steps && side.ends)) return GridLine::border;
    return i % side.line_every == 0 ? GridLine::inner : GridLine::none;
}

/// The face in the directions a and b; in the others it is where `at_end` says.
void add_rectangle(DomainGrid& grid, const std::vector<BoxSide>& sides, std::size_t a, std::size_t b,
                   std::size_t at_end) {
    const std::size_t first = grid.points.size();
    const auto at = [&](std::size_t i, std::size_t j) { return first + i * (sides[b].steps + 1) + j; };
    for (std::size_t i = 0; i <= sides[a].steps; ++i) {
        for (std::size_t j = 0; j <= sides[b].steps; ++j) {
            PatchPoint& point = grid.points.emplace_back();
            for (std::size_t d = 0; d < sides.size(); ++d) {
                point.push_back(d == a   ? on_segment(i, sides[a].steps)
                                : d == b ? on_segment(j, sides[b].steps)
                                         : on_segment(at_end >> d & 1, 1));
            }
            if (i == sides[a].steps || j == sides[b].steps) continue;
            grid.cells.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)},
                                  {line_at(sides[b], j), line_at(sides[a], i + 1), line_at(sides[b], j + 1),
                                   line_at(sides[a], i)}});
        }
    }
}

/// Whether the greater box has a face in the directions a and b here, at these ends of the others.
bool has_face(const std::vector<BoxSide>& sides, std::size_t a, std::size_t b, std::size_t at_end) {
    for (std::size_t d = 0; d < sides.size(); ++d) {
        const bool end = (at_end >> d & 1) != 0;
        if (d == a || d == b ? end : !(end ? sides[d].ends : sides[d].begins)) return false;
    }
    return true;
}

GridLine line_of_simplex(std::size_t i) {
    if (i == 0) return GridLine::border;
    return i % steps_a_line == 0 ? GridLine::inner : GridLine::none;
}

void add_triangle(DomainGrid& grid, std::size_t dimension, const std::array<std::size_t, 3>& vertices) {
    constexpr std::size_t steps = steps_of_simplex;
    const std::size_t first = grid.points.size();
    const auto at = [&](std::size_t i, std::size_t j) {
        return first + position(MultiIndex{steps - i - j, i, j});
    };
    for (const MultiIndex& index : multi_indices(2, steps)) {
        Coordinates point(dimension + 1);
        for (std::size_t k = 0; k < vertices.size(); ++k) point[vertices[k]] = Rational(index[k], steps);
        grid.points.push_back({std::move(point)});
    }
    for (std::size_t i = 0; i < steps; ++i) {
        for (std::size_t j = 0; i + j < steps; ++j) {
            const std::size_t k = steps - i - j;
            grid.cells.push_back({{at(i, j), at(i + 1, j), at(i, j + 1)},
                                  {line_of_simplex(j), line_of_simplex(k - 1), line_of_simplex(i)}});
            if (k < 2) continue;
            grid.cells.push_back({{at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)},
                                  {line_of_simplex(i + 1), line_of_simplex(j + 1), line_of_simplex(k - 1)}});
        }
    }
}

void add_segment(DomainGrid& grid, std::size_t steps) {
    for (std::size_t i = 0; i <= steps; ++i) {
        grid.line.push_back(grid.points.size());
        grid.points.push_back({on_segment(i, steps)});
    }
}

}  // namespace

DomainGrid grid_of_box(const std::vector<BoxSide>& sides) {
    DomainGrid grid;
    require_few_dimensions(sides.size());
    if (sides.size() == 1) add_segment(grid, sides.front().steps);
    for (std::size_t a = 0; a < sides.size(); ++a) {
        for (std::size_t b = a + 1; b < sides.size(); ++b) {
            for (std::size_t at_end = 0; at_end < std::size_t{1} << sides.size(); ++at_end) {
                if (has_face(sides, a, b, at_end)) add_rectangle(grid, sides, a, b, at_end);
            }
        }
    }
    return grid;
}

DomainGrid grid_of_simplex(std::size_t dimension) {
    DomainGrid grid;
    require_few_dimensions(dimension);
    if (dimension == 0) grid.points.push_back({{1}});
    if (dimension == 1) add_segment(grid, steps_of_simplex);
    for (std::size_t i = 0; i <= dimension; ++i) {
        for (std::size_t j = i + 1; j <= dimension; ++j) {
            for (std::size_t k = j + 1; k <= dimension; ++k) add_triangle(grid, dimension, {i, j, k});
        }
    }
    return grid;
}

}  // namespace blossom::protocol
