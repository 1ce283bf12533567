#include "surface/mesh.hpp"

#include <blossom/core/patch_blossom.hpp>

#include <map>
#include <numeric>

#include "operations/patch_answers.hpp"

namespace blossom::cli {

namespace {

constexpr std::size_t steps = 16;  ///< along a side of a box

/// One polynomial of what is shown, over its part of the domain.
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

/// The parameters of a point of the domain.
Coordinates parameters_of(const Patch& patch, const PatchPoint& point) {
    Coordinates numbers;
    const std::vector<BarycentricFrame> frames = domain_or_standard(patch);
    for (std::size_t f = 0; f < point.size(); ++f) {
        const Coordinates own = frames[f].combination(point[f]);
        numbers.insert(numbers.end(), own.begin(), own.end());
    }
    return numbers;
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
                    "/map");
    }
    if (dimension == 1) return parameters < 2 ? MeshSpace::plane_graph : MeshSpace::graph;
    return dimension == 2 ? MeshSpace::plane : MeshSpace::space;
}

/// A value of the map, taken at some parameters; none at infinity.
std::optional<SpacePoint> placed(Coordinates value, const PointForm& form, const Coordinates& parameters) {
    if (form.rational) {
        const Rational weight = value.back();
        if (weight.is_zero()) return {};
        value.pop_back();
        for (Rational& coordinate : value) coordinate /= weight;
    }
    if (value.size() == 1) value.insert(value.begin(), parameters.begin(), parameters.end());
    value.resize(3);
    return SpacePoint{value[0], value[1], value[2]};
}

/// Adds the places of pieces to a mesh, each place once.
class MeshBuilder {
public:
    MeshBuilder(Mesh& mesh, const Map& map, const Limits& limits) : mesh_(mesh), map_(map), limits_(limits) {}

    void add(const Piece& piece) {
        const auto values = evaluate(std::get<BezierPatch>(piece.patch.map), piece.grid.points, limits_);
        std::vector<std::optional<std::size_t>> numbers;
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
        const auto place = placed(value, map_.form, parameters);
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

/// Where a control point of a scalar map is shown: over the mean of its vertices.
PatchPoint mean_of(const std::vector<MultiIndex>& indices) {
    PatchPoint point;
    for (const MultiIndex& index : indices) {
        const std::size_t degree = std::accumulate(index.begin(), index.end(), std::size_t{0});
        Coordinates& own = point.emplace_back();
        for (const std::size_t entry : index) {
            own.push_back(degree == 0 ? Rational(1, index.size()) : Rational(entry, degree));
        }
    }
    return point;
}

/// The edges between points of a net that differ in one argument.
std::vector<std::pair<std::size_t, std::size_t>> edges_of(const NetShape& shape) {
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        if (shape[f].degree == 0) continue;
        const std::size_t vertices = shape[f].dimension + 1;
        const std::size_t behind = shape.behind(f);
        const auto raised = raised_positions(shape[f].dimension, shape[f].degree - 1);
        for (std::size_t first = 0; first < shape.size(); ++first) {
            // The first point of each row of this factor; the others follow at distances of `behind`.
            if (first / behind % shape.count(f) != 0) continue;
            for (std::size_t i = 0; i < raised.size(); ++i) {
                for (std::size_t k = i + 1; k < (i / vertices + 1) * vertices; ++k) {
                    edges.emplace_back(first + raised[i] * behind, first + raised[k] * behind);
                }
            }
        }
    }
    return edges;
}

void add_net(Mesh& mesh, const Patch& patch, const PointForm& form) {
    const auto& net = std::get<BezierPatch>(patch.map);
    const auto points = net.control_net().to_points();
    const auto indices = net_indices(net.shape());
    for (std::size_t i = 0; i < points.size(); ++i) {
        mesh.net.push_back(placed(points[i], form, parameters_of(patch, mean_of(indices[i]))));
    }
    mesh.net_edges = edges_of(net.shape());
}

void name_parameters(Mesh& mesh, const Patch& patch) {
    const std::string usual[] = {"u", "v"};
    for (std::size_t i = 0; i < 2; ++i)
        mesh.parameters[i] = i < patch.variables.size() ? patch.variables[i] : usual[i];
}

}  // namespace

Mesh mesh_of(const Map& map, const Limits& limits) {
    const Patch* patch = patch_of(map);
    if (!patch) throw Error(ErrorCode::wrong_kind, "only patches are surfaces; this map is a curve", "/map");
    Mesh mesh;
    mesh.space = space_of(patch->shape().dimension(), dimension_of(map) - (map.form.rational ? 1 : 0));
    MeshBuilder builder(mesh, map, limits);
    const std::vector<Piece> pieces = pieces_of(*patch, limits);
    for (const Piece& piece : pieces) builder.add(piece);
    add_net(mesh, pieces.front().patch, map.form);
    name_parameters(mesh, *patch);
    return mesh;
}

std::optional<SpacePoint> place_of_value(const Map& map, const Json& parameter, const Json& value,
                                         const Limits& limits) {
    const Patch& patch = *patch_of(map);
    const Coordinates numbers = read_tuple(parameter, patch.parameters(), limits);
    PatchPoint point = engine_arguments(patch, numbers, 1);
    const Coordinates parameters = patch.is_polynomial() ? numbers : parameters_of(patch, point);
    // Only homogeneous values carry their weight.
    return placed(answered_point(value), {.rational = map.form.homogeneous}, parameters);
}

}  // namespace blossom::cli
