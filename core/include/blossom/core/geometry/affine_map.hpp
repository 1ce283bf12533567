#pragma once

#include <blossom/core/geometry/simplex.hpp>

#include <vector>

namespace blossom::geometry {

/// The affine map that takes the vertices of a simplex to given points: T(sum a_i x_i) = sum a_i T(x_i) for
/// weights of sum 1. It is a blossom of one argument, see `Blossom::from_affine_map`.
///
/// The images may lie in a space of any dimension, and may be affinely dependent. Source: DeRose, section 6,
/// AffineMapCreate. Statements: derose-affine-map, derose-adt-affinemap.
class AffineMap {
public:
    /// Errors: `wrong_arity` unless there is one image per vertex; `different_spaces` among the images.
    AffineMap(Simplex domain, std::vector<Point> images);

    const Simplex& domain() const { return domain_; }
    const std::vector<Point>& images() const { return images_; }
    const Space& range() const { return images_.front().space(); }

    /// The image of a point. Errors: `different_spaces`; `outside_domain` for a point outside the affine hull
    /// of the domain. Source: DeRose, section 6, AffineMapEvaluate.
    Point operator()(const Point& point) const;
    /// The image of a vector: T(p + v) - T(p) for any p.
    Vector operator()(const Vector& vector) const;

private:
    Simplex domain_;
    std::vector<Point> images_;
};

/// The map x -> second(first(x)). Errors: `different_spaces`, `outside_domain`.
AffineMap composed(const AffineMap& second, const AffineMap& first);

}  // namespace blossom::geometry
