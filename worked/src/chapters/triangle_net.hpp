#pragma once

#include <blossom/core/maps/bezier_patch.hpp>
#include <blossom/worked/triangle_chapters.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "curve_pictures.hpp"

namespace blossom::worked {

/// The control net of a triangle and the point u of a page: blossom values at copies of u and of
/// the vertices r, s, t, with their names.
class TriangleNet {
public:
    /// Errors: `wrong_kind` unless the domain is one triangle; `not_affine` or `mismatched_dimensions` for
    /// `u`; `limit_exceeded`.
    TriangleNet(const GivenTriangle& given, Coordinates u, const Limits& limits);

    const BezierPatch& patch() const { return patch_; }
    std::size_t degree() const { return patch_.shape()[0].degree; }
    const Coordinates& u() const { return u_; }
    const std::array<Coordinates, 3>& vertices() const { return vertices_; }
    const Limits& limits() const { return limits_; }

    /// The value at i_0 copies of r, i_1 of s, i_2 of t, and u in all other arguments.
    Coordinates value(const MultiIndex& index) const;
    Formula name(const MultiIndex& index) const;
    /// The name, followed by its value.
    Formula known(const MultiIndex& index) const;
    /// The name as a combination of three names of the level before, with its value.
    Formula made(const MultiIndex& index) const;
    /// All values of a level, those with `level` copies of u.
    std::vector<MultiIndex> indices(std::size_t level) const;

private:
    BezierPatch patch_;
    Coordinates u_;
    std::array<Coordinates, 3> vertices_;
    Limits limits_;
};

/// A document on a map on a triangle: the map, its control points, and the point u.
Document begun(const GivenTriangle& given, const TriangleNet& net, std::string title, std::string source);

/// The steps that both chapters begin with: the control net of a polynomial, and the levels one by one.
void append_levels(Document& document, const GivenTriangle& given, const TriangleNet& net);

/// u = 1/2 r + 1/4 s + 1/4 t, and the coordinates of u if the vertices have coordinates.
Display point_display(const GivenTriangle& given, const TriangleNet& net);

/// Where names are drawn: the values of a map into the plane themselves, into space in a parallel projection,
/// otherwise the names over the triangle.
class TrianglePicture {
public:
    /// The greatest degree at which all points are named; more names would cover the picture.
    static constexpr std::size_t named_degree = 2;

    TrianglePicture(const GivenTriangle& given, const TriangleNet& net, std::string caption);

    /// The rows of the net of a level in the three directions.
    void add_net(std::size_t level, Role role);
    /// The net of the triangle in which u replaces a vertex.
    void add_part(std::size_t vertex, Role role);
    /// The curve over the side between two vertices, or between a vertex and u for 3.
    void add_side(std::size_t from, std::size_t to, Role role);
    void add_points(std::size_t level, Role role);
    Picture done() { return std::move(picture_); }

private:
    using Name = std::array<std::size_t, 4>;  ///< copies of r, s, t and u
    /// The rows of the net over three of r, s, t and u.
    void add_rows(const std::array<std::size_t, 3>& members, std::size_t level, Role role);
    PlanePoint place(const Name& name) const;
    PlanePoint shown(const Coordinates& value) const;

    const TriangleNet& net_;
    Picture picture_;
};

}  // namespace blossom::worked
