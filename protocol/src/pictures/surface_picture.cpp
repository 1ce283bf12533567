#include "surface_picture.hpp"

#include <blossom/worked/render.hpp>

#include <algorithm>

#include "drawn_curve.hpp"
#include "shading.hpp"
#include "view.hpp"

namespace blossom::protocol {

namespace {

using worked::Role;

constexpr std::size_t most_net_edges = 5000;
/// Those edges of the box that what is in it does not hide, or not all of.
constexpr std::pair<std::size_t, std::size_t> box_edges[] = {{0, 1}, {1, 3}, {3, 2}, {2, 0}, {0, 4},
                                                             {2, 6}, {3, 7}, {6, 7}, {4, 6}};

class SurfacePainting {
public:
    explicit SurfacePainting(const SurfacePicture& picture) : picture_(picture), view_(picture) {}

    worked::Picture drawing() {
        drawing_.caption = picture_.title;
        drawing_.width = picture_width;
        drawing_.graph = !view_.equal_scales();
        drawing_.grid = view_.is_plane();
        if (!view_.is_plane()) box();
        if (picture_.before) net(*picture_.before, Role::before);
        cells();
        for (const Mesh& mesh : picture_.meshes) {
            for (const auto& curve : mesh.curves) {
                worked::PictureCurve& line = drawing_.curves.emplace_back();
                for (const std::size_t i : curve) line.places.push_back(view_.place(mesh.places[i]));
            }
            net(mesh, Role::control);
        }
        const bool named = picture_.points.size() <= most_names;
        for (const SpaceMark& mark : picture_.points)
            drawing_.points.push_back(
                {view_.place(mark.place), worked::words(named ? mark.label : ""), Role::result});
        return std::move(drawing_);
    }

private:
    void line(const SpacePoint& a, const SpacePoint& b, Role role) {
        drawing_.lines.push_back({{view_.place(a), view_.place(b)}, role});
    }

    /// The edges of the box around everything, and the ranges of the coordinates along three of them.
    void box() {
        for (const auto& [a, b] : box_edges) line(view_.corner(a), view_.corner(b), Role::before);
        range(0, 1, 0, 18);
        range(1, 3, 8, 10);
        range(0, 4, -8, 4);
    }

    /// The numbers at the ends of an edge of the box along one coordinate, and its name between them.
    void range(std::size_t first, std::size_t last, int right, int below) {
        const std::size_t i = last - first == 4 ? 2 : last - first - 1;
        const worked::Place a = view_.place(view_.corner(first));
        const worked::Place b = view_.place(view_.corner(last));
        const auto& [least, greatest] = view_.bounds(i);
        drawing_.words.push_back({a, worked::short_text(least), right, below});
        drawing_.words.push_back({{(a.x + b.x) / 2, (a.y + b.y) / 2}, view_.name(i), right, below});
        drawing_.words.push_back({b, worked::short_text(greatest), right, below});
    }

    /// From the back to the front.
    void cells() {
        std::vector<std::pair<Rational, worked::PictureFace>> faces;
        for (std::size_t i = 0; i < picture_.meshes.size(); ++i) {
            const Mesh& mesh = picture_.meshes[i];
            for (const GridCell& cell : mesh.cells) {
                Rational depth;
                worked::PictureFace face{{}, cell.edges, shade(i, view_.tilt(mesh, cell)), line_colour(i)};
                for (const std::size_t corner : cell.corners) {
                    depth += mesh.places[corner].y;
                    face.places.push_back(view_.place(mesh.places[corner]));
                }
                faces.emplace_back(depth / Rational(cell.corners.size()), std::move(face));
            }
        }
        if (!view_.is_plane()) {
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
            if (point) drawing_.points.push_back({view_.place(*point), worked::words(""), role});
        }
    }

    const SurfacePicture& picture_;
    View view_;
    worked::Picture drawing_;
};

}  // namespace

std::string svg_of(const SurfacePicture& picture) {
    return worked::render_svg(SurfacePainting(picture).drawing());
}

}  // namespace blossom::protocol
