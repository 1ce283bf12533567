#pragma once

#include <blossom/core/geometry/space.hpp>
#include <blossom/core/maps/barycentric_frame.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace blossom::geometry {

/// Affinely independent points of one space: every point of their affine hull is an affine combination of
/// them in exactly one way. Source: DeRose, section 2. Statement: derose-barycentric.
class Simplex {
public:
    /// Errors: `different_spaces`, `wrong_arity` if there is no point, `degenerate_simplex` naming the
    /// vertices that are dependent.
    explicit Simplex(std::vector<Point> vertices);

    const Space& space() const { return vertices_.front().space(); }
    /// The number of vertices minus one, which is at most the dimension of the space.
    std::size_t dimension() const { return vertices_.size() - 1; }
    const std::vector<Point>& vertices() const { return vertices_; }
    const BarycentricFrame& frame() const { return frame_; }

    /// The barycentric coordinates of a point: the weights, of sum 1, of the affine combination of the
    /// vertices. Errors: `different_spaces`; `outside_domain` for a point outside the affine hull.
    Coordinates barycentric(const Point& point) const;
    /// The barycentric coordinates of a vector, of sum 0.
    Coordinates barycentric(const Vector& vector) const;
    /// The affine combination of the vertices. Errors: `not_affine`, `wrong_arity`.
    Point point(std::span<const Rational> weights) const;

    friend bool operator==(const Simplex&, const Simplex&) = default;

private:
    std::vector<Point> vertices_;
    BarycentricFrame frame_;
};

}  // namespace blossom::geometry
