#pragma once

#include <blossom/core/maps/point_array.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace blossom {

/// The vertices v_0, ..., v_s of a simplex in Q^d, s <= d, and their barycentric coordinates: each point of
/// the affine hull is sum x_k v_k with sum x_k = 1 in exactly one way, and each vector with sum x_k = 0.
/// Source: DeRose, section 2. Statement: derose-barycentric.
class BarycentricFrame {
public:
    /// Errors: `wrong_arity` if there is no vertex; `mismatched_dimensions` unless all have the same number
    /// of coordinates; `degenerate_simplex` naming the first vertices that are affinely dependent. The place
    /// is `Part::vertices / i`. Cost: O(d^3) operations.
    explicit BarycentricFrame(std::vector<Coordinates> vertices);
    /// The origin and the ends of the s unit vectors.
    static BarycentricFrame standard(std::size_t dimension);

    /// The dimension s of the simplex.
    std::size_t dimension() const { return vertices_.size() - 1; }
    /// The dimension d of the space.
    std::size_t space_dimension() const { return vertices_.front().size(); }
    const std::vector<Coordinates>& vertices() const { return vertices_; }

    /// The barycentric coordinates of a point, of sum 1. Cost: O(s d) operations. Errors:
    /// `mismatched_dimensions` for another number of coordinates; `outside_domain` if s < d and the point is
    /// not in the affine hull of the vertices.
    Coordinates of_point(std::span<const Rational> point) const;
    /// The barycentric coordinates of a vector, of sum 0.
    Coordinates of_vector(std::span<const Rational> vector) const;
    /// The coordinates x_k of sum `mass` with sum_k x_k v_k = u.
    Coordinates of_argument(std::span<const Rational> u, const Rational& mass) const;
    /// sum_k x_k v_k. Errors: `mismatched_dimensions`.
    Coordinates combination(std::span<const Rational> coordinates) const;

    friend bool operator==(const BarycentricFrame& a, const BarycentricFrame& b) {
        return a.vertices_ == b.vertices_;
    }

private:
    std::vector<Coordinates> vertices_;
    std::vector<Coordinates>
        inverse_;  ///< rows that give the coordinates of (mass, u), then those that give 0
};

}  // namespace blossom
