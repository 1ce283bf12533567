#include <blossom/rational/lists.hpp>
#include <numeric>

#include "mesh.hpp"

namespace blossom::protocol {

namespace {

/// The mean of the vertices of a control point, a point of the domain.
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

/// Greville's abscissa of a control point; of degree 0 the middle of its span.
Rational mean_of_knots(const KnotVector& knots, std::size_t point) {
    if (knots.degree() == 0) return (knots[point] + knots[point + 1]) / 2;
    const auto window = knots.window(point);
    return std::accumulate(window.begin(), window.end(), Rational()) / Rational(knots.degree());
}

}  // namespace

void add_net(Mesh& mesh, const Patch& patch, const PointForm& form) {
    const auto& net = std::get<BezierPatch>(patch.map);
    const auto points = net.control_net().to_points();
    const auto indices = net_indices(net.shape());
    for (std::size_t i = 0; i < points.size(); ++i) {
        mesh.net.push_back(placed(points[i], form.rational, parameters_of(patch, mean_of(indices[i]))));
    }
    mesh.net_edges = edges_of(net.shape());
}

void add_net(Mesh& mesh, const TensorBSpline& spline, const PointForm& form) {
    // The grid of control points is that of one Bezier patch.
    const NetShape grid =
        NetShape::tensor(mapped(spline.knots(), [&](const KnotVector& knots) { return knots.points() - 1; }));
    const auto indices = net_indices(grid);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        Coordinates parameters;
        for (std::size_t d = 0; d < spline.directions(); ++d)
            parameters.push_back(mean_of_knots(spline.knots(d), indices[i][d].back()));
        mesh.net.push_back(placed(spline.control_points()[i], form.rational, parameters));
    }
    mesh.net_edges = edges_of(grid);
}

}  // namespace blossom::protocol
