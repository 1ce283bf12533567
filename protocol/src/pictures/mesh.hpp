#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "domain_grid.hpp"
#include "maps/map.hpp"

namespace blossom::protocol {

/// A place in space, exact.
struct SpacePoint {
    Rational x;
    Rational y;
    Rational z;
};

/// The meaning of the places of a mesh.
enum class MeshSpace : unsigned char {
    plane,        ///< points of the plane, z is 0
    space,        ///< points of space
    plane_graph,  ///< (t, P(t)), z is 0
    graph,        ///< (u, v, P(u, v))
};

/// A patch as a mesh: places on the two-dimensional faces of its domain, with the
/// cells between them, and the control net.
struct Mesh {
    MeshSpace space = MeshSpace::space;
    std::vector<SpacePoint> places;
    std::vector<GridCell> cells;
    std::vector<std::vector<std::size_t>> curves;                ///< of a domain of one dimension
    std::vector<std::optional<SpacePoint>> net;                  ///< none for a point at infinity
    std::vector<std::pair<std::size_t, std::size_t>> net_edges;  ///< between neighbours in the net
    std::string parameters[2] = {"u", "v"};  ///< the names of the first parameters, for a graph
};

/// The points of a map of a domain of dimension 1 or more, or its graph over the first two parameters where
/// it is scalar; a polynomial over the unit box or simplex. Where a rational map has no point there is no
/// place, and no cell. Places that belong to the same point of the domain are one, unless the map jumps
/// there.
///
/// Cost: 153 or 289 values per face, of a B-spline at least one per Bezier patch. Errors: `wrong_kind` for a
/// map that is no patch; `mismatched_dimensions` for points of more than three dimensions, and for a graph
/// over more than two; `limit_exceeded` for a domain with very many faces.
Mesh mesh_of(const Map& map, const Limits& limits);

/// Adds the control net with the edges between points that differ in one argument. A control point of a
/// scalar map stands over the mean of its vertices or knots.
void add_net(Mesh& mesh, const Patch& patch, const PointForm& form);
void add_net(Mesh& mesh, const TensorBSpline& spline, const PointForm& form);

/// A value of a map at some parameters: its coordinates, or its graph where it is scalar; none at infinity.
std::optional<SpacePoint> placed(Coordinates value, bool rational, const Coordinates& parameters);

/// The parameters of a point of the domain; without vertices those of the unit simplex.
Coordinates parameters_of(const Patch& patch, const PatchPoint& point);

/// The place of a value of a result at a parameter of the request; none at infinity.
std::optional<SpacePoint> place_of_value(const Map& map, const Json& parameter, const Json& value,
                                         const Limits& limits);

}  // namespace blossom::protocol
