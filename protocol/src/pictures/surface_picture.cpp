#include "surface_picture.hpp"

#include <blossom/worked/render.hpp>

#include <algorithm>
#include <array>

#include "drawn_curve.hpp"
#include "shading.hpp"

namespace blossom::protocol {

namespace {

using worked::Role;

constexpr std::size_t most_net_edges = 5000;
/// The edges of the box that are visible at least in part.
constexpr std::pair<std::size_t, std::size_t> box_edges[] = {{0, 1}, {1, 3}, {3, 2}, {2, 0}, {0, 4},
                                                             {2, 6}, {3, 7}, {6, 7}, {4, 6}};

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

/// The projection of a picture of surfaces: parallel to the direction (-2/5, 1, -3/10), or, if all
/// places lie in the plane, the identity.
class SurfacePainting {
public:
    explicit SurfacePainting(const SurfacePicture& picture)
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

    worked::Picture drawing() {
        drawing_.caption = picture_.title;
        drawing_.width = picture_width;
        drawing_.graph = std::ranges::any_of(
            picture_.meshes, [](const Mesh& mesh) { return mesh.space == MeshSpace::plane_graph; });
        drawing_.grid = plane_;
        if (!plane_) box();
        if (picture_.before) net(*picture_.before, Role::before);
        cells();
        for (const Mesh& mesh : picture_.meshes) {
            for (const auto& curve : mesh.curves) {
                worked::PictureCurve& line = drawing_.curves.emplace_back();
                for (const std::size_t i : curve) line.places.push_back(place(mesh.places[i]));
            }
            net(mesh, Role::control);
        }
        const bool named = picture_.points.size() <= most_names;
        for (const SpaceMark& mark : picture_.points)
            drawing_.points.push_back(
                {place(mark.place), worked::words(named ? mark.label : ""), Role::result});
        return std::move(drawing_);
    }

private:
    void line(const SpacePoint& a, const SpacePoint& b, Role role) {
        drawing_.lines.push_back({{place(a), place(b)}, role});
    }

    /// The edges of the box around everything, and the ranges of the coordinates along three of them.
    void box() {
        for (const auto& [a, b] : box_edges) line(corner(a), corner(b), Role::before);
        range(0, 1, 0, 18);
        range(1, 3, 8, 10);
        range(0, 4, -8, 4);
    }

    /// The numbers at the ends of an edge of the box along one coordinate, and its name between them.
    void range(std::size_t first, std::size_t last, int right, int below) {
        const std::size_t i = last - first == 4 ? 2 : last - first - 1;
        const worked::PlanePoint a = place(corner(first));
        const worked::PlanePoint b = place(corner(last));
        const auto& [least, greatest] = bounds_[i];
        drawing_.words.push_back({a, worked::short_text(least), right, below});
        drawing_.words.push_back({{(a.x + b.x) / 2, (a.y + b.y) / 2}, names_[i], right, below});
        drawing_.words.push_back({b, worked::short_text(greatest), right, below});
    }

    /// From the back to the front.
    void cells() {
        std::vector<std::pair<Rational, worked::PictureFace>> faces;
        for (std::size_t i = 0; i < picture_.meshes.size(); ++i) {
            const Mesh& mesh = picture_.meshes[i];
            for (const GridCell& cell : mesh.cells) {
                Rational depth;
                worked::PictureFace face{{}, cell.edges, shade(i, tilt(mesh, cell)), line_colour(i)};
                for (const std::size_t corner : cell.corners) {
                    depth += mesh.places[corner].y;
                    face.places.push_back(place(mesh.places[corner]));
                }
                faces.emplace_back(depth / Rational(cell.corners.size()), std::move(face));
            }
        }
        if (!plane_) {
            std::ranges::stable_sort(faces, std::greater<>(), [](const auto& face) { return face.first; });
        }
        for (auto& [depth, face] : faces) drawing_.faces.push_back(std::move(face));
    }

    void net(const Mesh& mesh, Role role) {
        if (mesh.net_edges.size() > most_net_edges) return;
        for (const auto& [a, b] : mesh.net_edges) {
            if (mesh.net[a] && mesh.net[b]) line(*mesh.net[a], *mesh.net[b], role);
        }
        for (const auto& point : mesh.net) {
            if (point) drawing_.points.push_back({place(*point), worked::words(""), role});
        }
    }

    /// All places, of surfaces, nets and marks.
    std::vector<SpacePoint> all_places() const {
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

    SpacePoint scaled(const SpacePoint& point) const {
        return {point.x * scales_[0], point.y * scales_[1], point.z * scales_[2]};
    }

    worked::PlanePoint place(const SpacePoint& point) const {
        if (plane_) return {point.x, point.y};
        const SpacePoint at = scaled(point);
        return {at.x + Rational(2, 5) * at.y, at.z + Rational(3, 10) * at.y};
    }

    /// Corner i of the box: bit 0 of i is x, bit 1 y, bit 2 z.
    SpacePoint corner(std::size_t i) const {
        const auto end = [&](std::size_t k) {
            return (i >> k & 1) != 0 ? bounds_[k].second : bounds_[k].first;
        };
        return {end(0), end(1), end(2)};
    }

    /// The angle of the light on a cell.
    std::size_t tilt(const Mesh& mesh, const GridCell& cell) const {
        if (plane_) return greatest_tilt;
        // From above, from the left and from the front.
        const SpacePoint light{-2, -3, 5};
        const auto at = [&](std::size_t k) { return scaled(mesh.places[cell.corners[k]]); };
        const SpacePoint normal =
            cross(at(cell.corners.size() - 1) - at(1), at(2 % cell.corners.size()) - at(0));
        const Rational size = dot(normal, normal) * dot(light, light);
        if (size.is_zero()) return greatest_tilt;
        // The greatest k with k <= greatest_tilt |cos|, decided by squares.
        const Rational along = dot(normal, light);
        const Rational square = along * along * Rational(greatest_tilt * greatest_tilt);
        std::size_t k = 0;
        while (k < greatest_tilt && Rational((k + 1) * (k + 1)) * size <= square) ++k;
        return k;
    }

    const SurfacePicture& picture_;
    bool plane_;
    std::array<std::pair<Rational, Rational>, 3> bounds_;
    std::array<Rational, 3> scales_{1, 1, 1};
    std::array<std::string, 3> names_{"x", "y", "z"};
    worked::Picture drawing_;
};

}  // namespace

std::string svg_of(const SurfacePicture& picture) {
    return worked::render_svg(SurfacePainting(picture).drawing());
}

}  // namespace blossom::protocol
