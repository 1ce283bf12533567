#include "view.hpp"

#include <algorithm>

#include "shading.hpp"

namespace blossom::protocol {

namespace {

/// The length of the box of a graph in each direction.
const std::array<Rational, 3> box_of_graph{1, 1, Rational(7, 10)};

std::array<Rational, 3> coordinates(const SpacePoint& point) { return {point.x, point.y, point.z}; }

SpacePoint operator-(const SpacePoint& a, const SpacePoint& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

Rational dot(const SpacePoint& a, const SpacePoint& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

SpacePoint cross(const SpacePoint& a, const SpacePoint& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

bool lies_in_plane(const Mesh& mesh) {
    return mesh.space == MeshSpace::plane || mesh.space == MeshSpace::plane_graph;
}

}  // namespace

View::View(const SurfacePicture& picture)
    : picture_(picture), plane_(std::ranges::all_of(picture.meshes, lies_in_plane)) {
    const auto is_graph = [](const Mesh& mesh) { return mesh.space == MeshSpace::graph; };
    const std::vector<SpacePoint> places = all_places();
    if (!places.empty()) {
        for (std::size_t i = 0; i < 3; ++i) {
            bounds_[i] = {coordinates(places.front())[i], coordinates(places.front())[i]};
        }
    }
    for (const SpacePoint& place : places) {
        const auto numbers = coordinates(place);
        for (std::size_t i = 0; i < 3; ++i) {
            bounds_[i].first = std::min(bounds_[i].first, numbers[i]);
            bounds_[i].second = std::max(bounds_[i].second, numbers[i]);
        }
    }
    if (std::ranges::none_of(picture.meshes, is_graph)) return;
    names_ = {picture.meshes.front().parameters[0], picture.meshes.front().parameters[1], "P"};
    for (std::size_t i = 0; i < 3; ++i) {
        const Rational length = bounds_[i].second - bounds_[i].first;
        if (!length.is_zero()) scales_[i] = box_of_graph[i] / length;
    }
}

bool View::equal_scales() const {
    return std::ranges::none_of(picture_.meshes,
                                [](const Mesh& mesh) { return mesh.space == MeshSpace::plane_graph; });
}

std::vector<SpacePoint> View::all_places() const {
    std::vector<SpacePoint> places;
    const auto add_net = [&](const Mesh& mesh) {
        for (const auto& point : mesh.net) {
            if (point) places.push_back(*point);
        }
    };
    for (const Mesh& mesh : picture_.meshes) {
        places.insert(places.end(), mesh.places.begin(), mesh.places.end());
        add_net(mesh);
    }
    if (picture_.before) add_net(*picture_.before);
    for (const SpaceMark& mark : picture_.points) places.push_back(mark.place);
    return places;
}

SpacePoint View::scaled(const SpacePoint& point) const {
    return {point.x * scales_[0], point.y * scales_[1], point.z * scales_[2]};
}

worked::Place View::place(const SpacePoint& point) const {
    if (plane_) return {point.x, point.y};
    const SpacePoint at = scaled(point);
    return {at.x + Rational(2, 5) * at.y, at.z + Rational(3, 10) * at.y};
}

SpacePoint View::corner(std::size_t i) const {
    const auto end = [&](std::size_t k) { return (i >> k & 1) != 0 ? bounds_[k].second : bounds_[k].first; };
    return {end(0), end(1), end(2)};
}

std::size_t View::tilt(const Mesh& mesh, const GridCell& cell) const {
    if (plane_) return greatest_tilt;
    // From above, from the left and from the front.
    const SpacePoint light{-2, -3, 5};
    const auto at = [&](std::size_t k) { return scaled(mesh.places[cell.corners[k]]); };
    const SpacePoint normal = cross(at(cell.corners.size() - 1) - at(1), at(2 % cell.corners.size()) - at(0));
    const Rational size = dot(normal, normal) * dot(light, light);
    if (size.is_zero()) return greatest_tilt;
    // The greatest k with k <= greatest_tilt |cos|, decided by squares.
    const Rational along = dot(normal, light);
    const Rational square = along * along * Rational(greatest_tilt * greatest_tilt);
    std::size_t k = 0;
    while (k < greatest_tilt && Rational((k + 1) * (k + 1)) * size <= square) ++k;
    return k;
}

}  // namespace blossom::protocol
