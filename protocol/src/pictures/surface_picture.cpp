#include "surface_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "axes.hpp"
#include "frame.hpp"
#include "shading.hpp"
#include "svg_document.hpp"
#include "view.hpp"

namespace blossom::protocol {

namespace {

constexpr std::string_view net_colour = "#3c4043";
constexpr std::string_view faint_net_colour = "#9aa0a6";
constexpr std::string_view marked_colour = "#c5221f";
constexpr std::size_t most_labels_of_points = 16;
constexpr std::size_t most_net_edges = 5000;
/// Those edges of the box that what is in it does not hide, or not all of.
constexpr std::pair<std::size_t, std::size_t> box_edges[] = {{0, 1}, {1, 3}, {3, 2}, {2, 0}, {0, 4},
                                                             {2, 6}, {3, 7}, {6, 7}, {4, 6}};

class SurfacePainting {
public:
    explicit SurfacePainting(const SurfacePicture& picture)
        : picture_(picture),
          view_(picture),
          frame_(view_.places(), view_.equal_scales()),
          svg_(frame_.width(), frame_.height(), picture.title) {}

    std::string text() {
        svg_.add("rect", {{"width", "100%"}, {"height", "100%"}, {"fill", "white"}});
        if (view_.is_plane()) {
            paint_axes(svg_, frame_);
        } else {
            box();
        }
        if (picture_.before) net(*picture_.before, faint_net_colour);
        cells();
        for (std::size_t i = 0; i < picture_.meshes.size(); ++i) curves(picture_.meshes[i], i);
        for (const Mesh& mesh : picture_.meshes) net(mesh, net_colour);
        for (const SpaceMark& mark : picture_.points) point(mark);
        return svg_.text();
    }

private:
    std::string pixel(const SpacePoint& point, char separator = ',') const {
        const PlanePoint place = view_.place(point);
        return frame_.x(place.x) + separator + frame_.y(place.y);
    }

    /// The edges of the box around everything, and the ranges of the coordinates along three of them.
    void box() {
        const auto corner = [&](std::size_t i) { return view_.corner(i); };
        std::string path;
        for (const auto& [a, b] : box_edges) {
            path += fmt::format("M{} L{} ", pixel(corner(a)), pixel(corner(b)));
        }
        path.pop_back();
        svg_.add("path", {{"d", path}, {"fill", "none"}, {"stroke", "#dadce0"}, {"stroke-width", "1"}});
        range(0, corner(0), corner(1), "middle", "0", "18");
        range(1, corner(1), corner(3), "start", "8", "10");
        range(2, corner(0), corner(4), "end", "-8", "4");
    }

    /// The numbers at the ends of the edge of the box along coordinate i, and its name between them.
    void range(std::size_t i, const SpacePoint& first, const SpacePoint& last, std::string_view anchor,
               const std::string& dx, const std::string& dy) {
        const SpacePoint middle{(first.x + last.x) / 2, (first.y + last.y) / 2, (first.z + last.z) / 2};
        const auto text = [&](const SpacePoint& at, const std::string& written, std::string_view style) {
            const PlanePoint place = view_.place(at);
            svg_.add("text",
                     {{"x", frame_.x(place.x)},
                      {"y", frame_.y(place.y)},
                      {"dx", dx},
                      {"dy", dy},
                      {"text-anchor", std::string(anchor)},
                      {"font-style", std::string(style)},
                      {"fill", "#5f6368"}},
                     written);
        };
        text(first, tick_text(view_.bounds(i).first), "normal");
        text(middle, view_.name(i), "italic");
        text(last, tick_text(view_.bounds(i).second), "normal");
    }

    void cells() {
        std::vector<std::pair<std::size_t, std::size_t>> order;
        std::vector<std::vector<Rational>> depths(picture_.meshes.size());
        for (std::size_t i = 0; i < picture_.meshes.size(); ++i) {
            const Mesh& mesh = picture_.meshes[i];
            for (std::size_t k = 0; k < mesh.cells.size(); ++k) {
                order.emplace_back(i, k);
                Rational sum;
                for (const std::size_t corner : mesh.cells[k].corners) sum += mesh.places[corner].y;
                depths[i].push_back(sum / Rational(mesh.cells[k].corners.size()));
            }
        }
        if (!view_.is_plane()) {
            std::ranges::stable_sort(order, [&](const auto& a, const auto& b) {
                return depths[b.first][b.second] < depths[a.first][a.second];
            });
        }
        for (const auto& [i, k] : order) cell(picture_.meshes[i], picture_.meshes[i].cells[k], i);
    }

    void cell(const Mesh& mesh, const GridCell& cell, std::size_t colour) {
        std::string outline;
        std::array<std::string, 3> lines;
        for (std::size_t k = 0; k < cell.corners.size(); ++k) {
            const std::string from = pixel(mesh.places[cell.corners[k]]);
            const std::string to = pixel(mesh.places[cell.corners[(k + 1) % cell.corners.size()]]);
            outline += (k == 0 ? "" : " ") + from;
            lines[static_cast<std::size_t>(cell.edges[k])] += fmt::format("M{} L{}", from, to);
        }
        const std::string fill = shade(colour, view_.tilt(mesh, cell));
        svg_.add("polygon", {{"points", outline}, {"fill", fill}, {"stroke", fill}, {"stroke-width", "0.6"}});
        stroke(lines[static_cast<std::size_t>(GridLine::inner)], colour, "0.7");
        stroke(lines[static_cast<std::size_t>(GridLine::border)], colour, "1.6");
    }

    void stroke(const std::string& path, std::size_t colour, const std::string& width) {
        if (path.empty()) return;
        svg_.add("path", {{"d", path},
                          {"fill", "none"},
                          {"stroke", line_colour(colour)},
                          {"stroke-width", width},
                          {"stroke-linecap", "round"}});
    }

    void curves(const Mesh& mesh, std::size_t colour) {
        for (const auto& curve : mesh.curves) {
            std::string path;
            for (const std::size_t place : curve)
                path += (path.empty() ? "M" : " L") + pixel(mesh.places[place]);
            stroke(path, colour, "2.5");
        }
    }

    void net(const Mesh& mesh, std::string_view colour) {
        if (mesh.net_edges.size() > most_net_edges) return;
        std::string path;
        for (const auto& [a, b] : mesh.net_edges) {
            if (mesh.net[a] && mesh.net[b])
                path += fmt::format("M{} L{}", pixel(*mesh.net[a]), pixel(*mesh.net[b]));
        }
        if (!path.empty()) {
            svg_.add("path", {{"d", path},
                              {"fill", "none"},
                              {"stroke", std::string(colour)},
                              {"stroke-width", "0.9"},
                              {"stroke-dasharray", "5 3"}});
        }
        for (const auto& point : mesh.net) {
            if (!point) continue;
            const PlanePoint place = view_.place(*point);
            svg_.add("circle", {{"cx", frame_.x(place.x)},
                                {"cy", frame_.y(place.y)},
                                {"r", "3"},
                                {"fill", std::string(colour)},
                                {"stroke", "white"},
                                {"stroke-width", "0.8"}});
        }
    }

    void point(const SpaceMark& mark) {
        const PlanePoint place = view_.place(mark.place);
        const std::string x = frame_.x(place.x);
        const std::string y = frame_.y(place.y);
        svg_.add("circle", {{"cx", x}, {"cy", y}, {"r", "4.5"}, {"fill", std::string(marked_colour)}});
        if (picture_.points.size() > most_labels_of_points) return;
        svg_.add("text",
                 {{"x", x},
                  {"y", y},
                  {"dy", "-10"},
                  {"text-anchor", "middle"},
                  {"fill", std::string(marked_colour)},
                  {"stroke", "white"},
                  {"stroke-width", "3"},
                  {"paint-order", "stroke"}},
                 mark.label);
    }

    const SurfacePicture& picture_;
    View view_;
    Frame frame_;
    SvgDocument svg_;
};

}  // namespace

std::string svg_of(const SurfacePicture& picture) { return SurfacePainting(picture).text(); }

}  // namespace blossom::protocol
