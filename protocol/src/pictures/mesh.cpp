#include "mesh.hpp"

#include <blossom/core/blossom/patch_blossom.hpp>
#include <blossom/core/nurbs/rational_curve.hpp>
#include <blossom/core/patch/tensor_bspline_change.hpp>

#include <algorithm>
#include <map>

#include "operations/control_nets.hpp"
#include "operations/segment.hpp"

namespace blossom::protocol {

namespace {

constexpr std::size_t steps = 16;       ///< along a side of a box
constexpr std::size_t most_lines = 12;  ///< along a side with several spans

/// One polynomial of the map, over its part of the domain.
struct Piece {
    Patch patch;
    DomainGrid grid;
};

std::vector<Piece> pieces_of(const Patch& patch, const Limits& limits) {
    Patch net = as_net(patch, limits);
    const std::size_t dimension = net.shape().dimension();
    DomainGrid grid =
        net.tensor ? grid_of_box(std::vector<BoxSide>(dimension, {steps, 2})) : grid_of_simplex(dimension);
    return {{std::move(net), std::move(grid)}};
}

/// The Bezier patches of B-splines that have a face on the boundary of the domain: all of a surface. The more
/// of them there are, the fewer cells has each, and the lines are at knots if these are many.
std::vector<Piece> pieces_of(const TensorBSpline& spline, const Limits& limits) {
    std::vector<BoxSide> sides;
    for (const KnotVector& knots : spline.knots()) {
        const std::size_t spans = knots.spans().size();
        const std::size_t lines = spans == 1 ? steps / 2 : std::max<std::size_t>(most_lines / spans, 1);
        sides.push_back(spans > 2 * most_lines ? BoxSide{1, 1} : BoxSide{2 * lines, 2});
    }
    std::vector<Piece> pieces;
    for (const auto& spans : boxes_of(spline, limits)) {
        for (std::size_t d = 0; d < spans.size(); ++d) {
            const auto own = spline.knots(d).spans();
            sides[d].begins = spans[d] == own.front();
            sides[d].ends = spans[d] == own.back();
        }
        DomainGrid grid = grid_of_box(sides);
        if (!grid.points.empty()) pieces.push_back({segment(spline, spans, limits), std::move(grid)});
    }
    return pieces;
}

MeshSpace space_of(std::size_t parameters, std::size_t dimension) {
    if (dimension > 3 || (dimension == 1 && parameters > 2)) {
        const std::string what = dimension > 3 ? "points of dimension " + std::to_string(dimension)
                                               : "the graph of a scalar map over a domain of dimension " +
                                                     std::to_string(parameters);
        throw Error(ErrorCode::mismatched_dimensions,
                    what +
                        " cannot be shown in space; points have dimension 2 or 3 there, and a scalar map at "
                        "most two parameters",
                    Place{"map"});
    }
    if (dimension == 1) return parameters < 2 ? MeshSpace::plane_graph : MeshSpace::graph;
    return dimension == 2 ? MeshSpace::plane : MeshSpace::space;
}

/// Adds the places of pieces to a mesh, each place once.
class MeshBuilder {
public:
    MeshBuilder(Mesh& mesh, const Map& map, const Limits& limits) : mesh_(mesh), map_(map), limits_(limits) {}

    void add(const Piece& piece) {
        const auto values = evaluate(std::get<BezierPatch>(piece.patch.map), piece.grid.points, limits_);
        std::vector<std::optional<std::size_t>> numbers;
        numbers.reserve(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            numbers.push_back(number(parameters_of(piece.patch, piece.grid.points[i]), values[i]));
        }
        for (const GridCell& cell : piece.grid.cells) {
            GridCell renumbered{{}, cell.edges};
            for (const std::size_t corner : cell.corners) {
                if (numbers[corner]) renumbered.corners.push_back(*numbers[corner]);
            }
            if (renumbered.corners.size() == cell.corners.size())
                mesh_.cells.push_back(std::move(renumbered));
        }
        add_curve(piece.grid.line, numbers);
    }

private:
    /// The number of a place, new or known.
    std::optional<std::size_t> number(Coordinates parameters, const Coordinates& value) {
        const auto place = placed(value, map_.form.rational, parameters);
        if (!place) return {};
        const auto [entry, is_new] = known_.try_emplace({std::move(parameters), value}, mesh_.places.size());
        if (is_new) mesh_.places.push_back(*place);
        return entry->second;
    }
    void add_curve(const std::vector<std::size_t>& line,
                   const std::vector<std::optional<std::size_t>>& numbers) {
        bool broken = true;
        for (const std::size_t i : line) {
            if (numbers[i] && broken) mesh_.curves.emplace_back();
            broken = !numbers[i];
            if (numbers[i]) mesh_.curves.back().push_back(*numbers[i]);
        }
    }

    Mesh& mesh_;
    const Map& map_;
    const Limits& limits_;
    std::map<std::pair<Coordinates, Coordinates>, std::size_t> known_;
};

}  // namespace

std::optional<SpacePoint> placed(Coordinates value, bool rational, const Coordinates& parameters) {
    if (rational) {
        if (value.back().is_zero()) return {};
        value = projected(value);
    }
    if (value.size() == 1) value.insert(value.begin(), parameters.begin(), parameters.end());
    value.resize(3);
    return SpacePoint{value[0], value[1], value[2]};
}

Coordinates parameters_of(const Patch& patch, const PatchPoint& point) {
    Coordinates numbers;
    const std::vector<BarycentricFrame> frames = domain_or_standard(patch);
    for (std::size_t f = 0; f < point.size(); ++f) {
        const Coordinates own = frames[f].combination(point[f]);
        numbers.insert(numbers.end(), own.begin(), own.end());
    }
    return numbers;
}

std::optional<SpacePoint> place_of_value(const Map& map, const Json& parameter, const Json& value,
                                         const Limits& limits) {
    Coordinates numbers = read_numbers(parameter, limits);
    const auto* patch = std::get_if<Patch>(&map.value);
    if (patch && patch->is_barycentric())
        numbers = parameters_of(*patch, engine_arguments(*patch, numbers, 1));
    // Only homogeneous values contain their weight.
    return placed(answered_point(value), map.form.homogeneous, numbers);
}

Mesh mesh_of(const Map& map, const Limits& limits) {
    const Patch* patch = std::get_if<Patch>(&map.value);
    const TensorBSpline* spline = std::get_if<TensorBSpline>(&map.value);
    if (!patch && !spline)
        throw Error(ErrorCode::wrong_kind, "only patches are surfaces; this map is a curve", Place{"map"});
    Mesh mesh;
    mesh.space = space_of(patch ? patch->shape().dimension() : spline->directions(),
                          dimension_of(map) - (map.form.rational ? 1 : 0));
    MeshBuilder builder(mesh, map, limits);
    const std::vector<Piece> pieces = patch ? pieces_of(*patch, limits) : pieces_of(*spline, limits);
    for (const Piece& piece : pieces) builder.add(piece);
    if (patch) {
        add_net(mesh, pieces.front().patch, map.form);
        for (std::size_t i = 0; i < std::min<std::size_t>(patch->variables.size(), 2); ++i)
            mesh.parameters[i] = patch->variables[i];
    } else {
        add_net(mesh, *spline, map.form);
    }
    return mesh;
}

}  // namespace blossom::protocol
