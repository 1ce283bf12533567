#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "surface_picture.hpp"

namespace blossom::protocol {

/// How the places of a picture of surfaces are seen: parallel to the direction (-2/5, 1, -3/10), or, when all
/// of them lie in the plane, as they are.
class View {
public:
    explicit View(const SurfacePicture& picture);

    bool is_plane() const { return plane_; }
    /// Whether lengths are the same in all directions of the picture.
    bool equal_scales() const;
    worked::Place place(const SpacePoint& point) const;
    /// Corner i of the box: bit 0 of i is x, bit 1 y, bit 2 z.
    SpacePoint corner(std::size_t i) const;
    /// The name of coordinate i.
    const std::string& name(std::size_t i) const { return names_[i]; }
    /// What coordinate i runs through.
    const std::pair<Rational, Rational>& bounds(std::size_t i) const { return bounds_[i]; }
    /// How steeply light falls on a cell.
    std::size_t tilt(const Mesh& mesh, const GridCell& cell) const;

private:
    /// All places, of surfaces, nets and marks.
    std::vector<SpacePoint> all_places() const;
    SpacePoint scaled(const SpacePoint& point) const;

    const SurfacePicture& picture_;
    bool plane_;
    std::array<std::pair<Rational, Rational>, 3> bounds_;
    std::array<Rational, 3> scales_{1, 1, 1};
    std::array<std::string, 3> names_{"x", "y", "z"};
};

}  // namespace blossom::protocol
