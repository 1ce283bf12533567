#include <blossom/core/geometry/simplex.hpp>
#include <blossom/rational/error.hpp>

#include <utility>

namespace blossom::geometry {

namespace {

BarycentricFrame frame_of(const std::vector<Point>& vertices) {
    std::vector<Coordinates> coordinates;
    for (const Point& vertex : vertices) {
        require_same_space(vertices.front().space(), vertex.space());
        coordinates.push_back(vertex.coordinates());
    }
    return BarycentricFrame(std::move(coordinates));
}

}  // namespace

Simplex::Simplex(std::vector<Point> vertices) : vertices_(std::move(vertices)), frame_(frame_of(vertices_)) {}

Coordinates Simplex::barycentric(const Point& point) const {
    require_same_space(space(), point.space());
    return frame_.of_point(point.coordinates());
}

Coordinates Simplex::barycentric(const Vector& vector) const {
    require_same_space(space(), vector.space());
    return frame_.of_vector(vector.coordinates());
}

Point Simplex::point(std::span<const Rational> weights) const {
    return affine_combination(vertices_, weights);
}

}  // namespace blossom::geometry
