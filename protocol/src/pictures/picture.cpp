#include "picture.hpp"

#include <fmt/format.h>

#include <array>

#include "axes.hpp"
#include "frame.hpp"
#include "svg_document.hpp"

namespace blossom::protocol {

namespace {

constexpr std::string_view faint_colour = "#9aa0a6";
constexpr std::array<std::string_view, 4> colours = {"#1a73e8", "#d9600a", "#188038", "#9334e6"};
constexpr std::string_view point_colour = "#c5221f";
constexpr std::size_t most_labels = 16;
constexpr std::size_t most_dots = 400;

class Painting {
public:
    explicit Painting(const Picture& picture)
        : picture_(picture), frame_(picture), svg_(frame_.width(), frame_.height(), picture.title) {}

    std::string text() {
        svg_.add("rect", {{"width", "100%"}, {"height", "100%"}, {"fill", "white"}});
        paint_axes(svg_, frame_);
        std::size_t next_colour = 0;
        std::vector<std::string> used;
        for (const PictureLayer& layer : picture_.layers) {
            used.emplace_back(layer.faint ? faint_colour : colours[next_colour++ % colours.size()]);
            polygon(layer, used.back());
        }
        for (std::size_t i = 0; i < picture_.layers.size(); ++i) curve(picture_.layers[i], used[i]);
        for (std::size_t i = 0; i < picture_.layers.size(); ++i) knots(picture_.layers[i], used[i]);
        for (const Mark& mark : picture_.points) point(mark);
        legend(used);
        return svg_.text();
    }

private:
    std::string points_text(const std::vector<PlanePoint>& line) const {
        std::string text;
        for (const PlanePoint& place : line)
            text += (text.empty() ? "" : " ") + frame_.x(place.x) + "," + frame_.y(place.y);
        return text;
    }

    void label(const std::string& x, const std::string& y, std::string_view anchor, std::string_view colour,
               const std::string& shift, const std::string& text) {
        svg_.add("text",
                 {{"x", x},
                  {"y", y},
                  {"dy", shift},
                  {"text-anchor", std::string(anchor)},
                  {"fill", std::string(colour)},
                  {"stroke", "white"},
                  {"stroke-width", "3"},
                  {"paint-order", "stroke"}},
                 text);
    }

    void polygon(const PictureLayer& layer, const std::string& colour) {
        std::size_t dots = 0;
        for (const auto& line : layer.curve.polygon) {
            svg_.add("polyline", {{"points", points_text(line)},
                                  {"fill", "none"},
                                  {"stroke", colour},
                                  {"stroke-width", "1"},
                                  {"stroke-dasharray", layer.faint ? "2 4" : "5 3"}});
            for (const PlanePoint& place : line) {
                if (dots++ == most_dots) return;
                svg_.add("circle", {{"cx", frame_.x(place.x)},
                                    {"cy", frame_.y(place.y)},
                                    {"r", layer.faint ? "5" : "3.5"},
                                    {"fill", layer.faint ? "white" : colour},
                                    {"stroke", colour}});
            }
        }
    }

    void curve(const PictureLayer& layer, const std::string& colour) {
        for (const auto& line : layer.curve.lines) {
            svg_.add("polyline", {{"points", points_text(line)},
                                  {"fill", "none"},
                                  {"stroke", colour},
                                  {"stroke-opacity", layer.faint ? "0.5" : "1"},
                                  {"stroke-width", layer.faint ? "7" : "2.5"},
                                  {"stroke-linejoin", "round"},
                                  {"stroke-linecap", "round"}});
        }
    }

    void knots(const PictureLayer& layer, const std::string& colour) {
        const auto& marks = layer.curve.knots;
        if (layer.faint || marks.size() > most_dots) return;
        for (const Mark& mark : marks) {
            const std::string x = frame_.x(mark.place.x);
            const std::string y = frame_.y(mark.place.y);
            svg_.add("rect", {{"x", x},
                              {"y", y},
                              {"width", "7"},
                              {"height", "7"},
                              {"transform", "translate(-3.5 -3.5)"},
                              {"fill", "white"},
                              {"stroke", colour},
                              {"stroke-width", "1.5"}});
            if (marks.size() <= most_labels) label(x, y, "middle", colour, "20", "t = " + mark.label);
        }
    }

    void point(const Mark& mark) {
        const std::string x = frame_.x(mark.place.x);
        const std::string y = frame_.y(mark.place.y);
        svg_.add("circle", {{"cx", x}, {"cy", y}, {"r", "4"}, {"fill", std::string(point_colour)}});
        if (picture_.points.size() <= most_labels) label(x, y, "middle", point_colour, "-10", mark.label);
    }

    void legend(const std::vector<std::string>& used) {
        std::size_t x = Frame::margin;
        for (std::size_t i = 0; i < used.size() && i < colours.size() + 1; ++i) {
            const std::string& name = picture_.layers[i].name;
            if (name.empty()) continue;
            svg_.add(
                "rect",
                {{"x", std::to_string(x)}, {"y", "8"}, {"width", "14"}, {"height", "4"}, {"fill", used[i]}});
            svg_.add("text", {{"x", std::to_string(x + 20)}, {"y", "14"}, {"fill", "#3c4043"}}, name);
            constexpr std::size_t character = 7;
            x += 40 + character * name.size();
        }
    }

    const Picture& picture_;
    Frame frame_;
    SvgDocument svg_;
};

}  // namespace

std::string svg_of(const Picture& picture) { return Painting(picture).text(); }

}  // namespace blossom::protocol
