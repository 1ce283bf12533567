#include <blossom/core/curve/degree_elevation.hpp>
#include <blossom/core/patch/patch_graph.hpp>
#include <blossom/rational/error.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "blossom/patch_product.hpp"
#include "tensor_rows.hpp"

namespace blossom {

namespace {

/// The vertices of each factor, unit vectors for barycentric parameters.
std::vector<std::vector<Coordinates>> vertices_of_factors(const NetShape& shape,
                                                          std::span<const BarycentricFrame> frames) {
    std::vector<std::vector<Coordinates>> vertices;
    for (std::size_t f = 0; f < shape.factors(); ++f) {
        if (f < frames.size()) {
            vertices.push_back(frames[f].vertices());
            continue;
        }
        std::vector<Coordinates> units(shape[f].dimension + 1, Coordinates(shape[f].dimension + 1));
        for (std::size_t k = 0; k < units.size(); ++k) units[k][k] = 1;
        vertices.push_back(std::move(units));
    }
    return vertices;
}

/// The net of the parameter itself, of the degrees of the shape, none of which is 0: the means of vertices.
BezierPatch parameter_net(const NetShape& shape, std::span<const BarycentricFrame> frames) {
    const auto vertices = vertices_of_factors(shape, frames);
    std::vector<Coordinates> points;
    points.reserve(shape.size());
    for (const auto& indices : net_indices(shape)) {
        Coordinates& point = points.emplace_back();
        for (std::size_t f = 0; f < indices.size(); ++f) {
            for (std::size_t c = 0; c < vertices[f].front().size(); ++c) {
                Rational sum;
                for (std::size_t k = 0; k < indices[f].size(); ++k)
                    sum += Rational(indices[f][k]) * vertices[f][k][c];
                point.push_back(sum / Rational(shape[f].degree));
            }
        }
    }
    return {shape, PointArray(points)};
}

NetShape with_degrees_at_least(const NetShape& shape, std::size_t least, std::size_t more,
                               const Limits& limits) {
    std::vector<SimplexFactor> factors = shape.list();
    for (SimplexFactor& factor : factors) factor.degree = std::max(factor.degree + more, least);
    return NetShape(std::move(factors), limits);
}

std::vector<std::size_t> degrees_in(const NetShape& shape) {
    std::vector<std::size_t> degrees;
    for (const SimplexFactor& factor : shape.list()) degrees.push_back(factor.degree);
    return degrees;
}

/// Both over the same shape, the coordinates of the first in front.
BezierPatch joined_nets(const BezierPatch& first, const BezierPatch& second) {
    std::vector<Coordinates> points = first.control_net().to_points();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Coordinates more = second.control_net()[i];
        points[i].insert(points[i].end(), more.begin(), more.end());
    }
    return {first.shape(), PointArray(points)};
}

/// The last coordinate times all coordinates of the other.
BezierPatch times_weight(const BezierPatch& patch, const BezierPatch& other, const Limits& limits) {
    const Form weight = form_rows(patch);
    Form product = form_rows(other);
    const ProductTable table(weight.shape, product.shape, limits);
    for (auto& row : product.rows) row = table.product(weight.rows.back(), row);
    return patch_of<BezierPatch>(
        {table.shape(), std::move(product.rows), weight.denominator * product.denominator});
}

}  // namespace

BezierPatch graph(const BezierPatch& patch, std::span<const BarycentricFrame> frames, GraphForm form,
                  const Limits& limits) {
    const bool weighted = form == GraphForm::homogeneous;
    const NetShape shape = with_degrees_at_least(patch.shape(), 1, weighted ? 1 : 0, limits);
    const BezierPatch raised = elevated_to(patch, degrees_in(shape), limits);
    if (!weighted) return joined_nets(parameter_net(shape, frames), raised);
    std::vector<SimplexFactor> linear = patch.shape().list();
    for (SimplexFactor& factor : linear) factor.degree = 1;
    const BezierPatch parameter = parameter_net(NetShape(std::move(linear), limits), frames);
    return joined_nets(times_weight(patch, parameter, limits), raised);
}

PolynomialPatch graph(const PolynomialPatch& patch, GraphForm form, const Limits& limits) {
    const bool weighted = form == GraphForm::homogeneous;
    const NetShape shape = with_degrees_at_least(patch.shape(), 1, weighted ? 1 : 0, limits);
    std::vector<SparsePolynomial> coordinates;
    for (std::size_t i = 0; i < shape.dimension(); ++i) {
        const SparsePolynomial x = SparsePolynomial::variable(i);
        coordinates.push_back(weighted ? x * patch.coordinate(patch.dimension() - 1) : x);
    }
    for (std::size_t j = 0; j < patch.dimension(); ++j) coordinates.push_back(patch.coordinate(j));
    return {shape, coordinates, limits};
}

TensorBSpline graph(const TensorBSpline& spline, GraphForm form, const Limits& limits) {
    std::vector<KnotVector> knots = spline.knots();
    PointGrid grid = grid_of(spline);
    for (std::size_t d = knots.size(); d-- > 0;) {
        const KnotVector own = knots[d];
        grid = along_rows(grid, d, [&](std::vector<Coordinates> points) {
            const BSplineCurve row = graph(BSplineCurve(own, std::move(points)), form, limits);
            knots[d] = row.knots();
            return row.control_points();
        });
        require_within(grid.points.size() * grid.points.front().size(), limits.numbers, "numbers",
                       "the number of coordinates");
    }
    return {std::move(knots), std::move(grid.points)};
}

}  // namespace blossom
