#include <blossom/worked/render.hpp>

#include <string>

#include "mathml.hpp"
#include "svg.hpp"
#include "svg_elements.hpp"

namespace blossom::worked {

namespace {

constexpr Length tick_length = 40;

std::string coordinates(const Spot& spot) { return pixels(spot.x) + " " + pixels(spot.y); }

std::string path_data(const Drawing::Path& path) {
    std::string data = "M" + coordinates(path.spots.front());
    for (std::size_t i = 1; i < path.spots.size(); ++i) {
        data += (i == 1 ? (path.cubic ? " C" : " L") : " ") + coordinates(path.spots[i]);
    }
    return data;
}

void append_axes(pugi::xml_node svg, const Drawing& drawing) {
    for (const Segment& axis : drawing.axes) append_line(svg, axis, "axis");
    for (const Drawing::Tick& mark : drawing.ticks) {
        const Spot& spot = mark.spot;
        if (mark.horizontal) {
            append_line(svg, {spot, {spot.x, spot.y + tick_length}}, "axis");
            append_label(svg, {spot.x, spot.y + 4 * tick_length}, "middle", "number", mark.text);
        } else {
            append_line(svg, {{spot.x - tick_length, spot.y}, spot}, "axis");
            append_label(svg, {spot.x - 2 * tick_length, spot.y}, "end", "number", mark.text);
        }
    }
}

void append_paths(pugi::xml_node svg, const Drawing& drawing) {
    for (const Drawing::Path& path : drawing.paths) {
        pugi::xml_node node = svg.append_child("path");
        node.append_attribute("d") = path_data(path).c_str();
        node.append_attribute("class") =
            (std::string(path.is_curve ? "curve " : "line ") + role_name(path.role)).c_str();
    }
}

void append_points(pugi::xml_node svg, const Drawing& drawing, const Notation& notation) {
    for (const Drawing::Label& label : drawing.labels) {
        if (label.leader) append_line(svg, *label.leader, "leader");
    }
    for (const Drawing::Dot& dot : drawing.dots) {
        pugi::xml_node circle = svg.append_child("circle");
        circle.append_attribute("cx") = pixels(dot.spot.x).c_str();
        circle.append_attribute("cy") = pixels(dot.spot.y).c_str();
        circle.append_attribute("r") = dot.role >= Role::result ? "4.5" : "3.5";
        circle.append_attribute("class") = ("dot " + role_name(dot.role)).c_str();
    }
    for (std::size_t i = 0; i < drawing.labels.size(); ++i) {
        const Box& box = drawing.labels[i].box;
        append_label(svg, {(box.left + box.right) / 2, (box.top + box.bottom) / 2}, "middle",
                     ("label " + role_name(drawing.dots[i].role)).c_str(),
                     to_text(label_formula(drawing.labels[i]), notation));
    }
}

}  // namespace

pugi::xml_node append_picture(pugi::xml_node parent, const Picture& picture, const Notation& notation,
                              std::size_t number) {
    const Drawing drawing = drawn(picture, notation);
    pugi::xml_node svg = append_svg(parent, drawing.width, drawing.height, "picture" + std::to_string(number),
                                    picture.caption, picture.description);
    svg.append_attribute("class") = "picture";
    append_axes(svg, drawing);
    append_paths(svg, drawing);
    append_points(svg, drawing, notation);
    return svg;
}

std::string svg_style() {
    return "svg text{font:15px system-ui,'Segoe UI','DejaVu Sans',sans-serif;fill:var(--ink);"
           "paint-order:stroke;stroke:var(--paper);stroke-width:4px;stroke-linejoin:round}"
           "svg .number,svg .weight{font-size:13px;fill:var(--soft)}"
           "svg path{fill:none}"
           "svg .axis{stroke:var(--soft);stroke-width:1}"
           "svg .leader{stroke:var(--soft);stroke-width:.8;stroke-dasharray:2 2}"
           "svg .line{stroke:var(--faint);stroke-width:1.2}"
           "svg .line.control{stroke:var(--soft);stroke-width:1.6;stroke-dasharray:6 4}"
           "svg .line.result{stroke:var(--result);stroke-width:2}"
           "svg .line.second{stroke:var(--second);stroke-width:2;stroke-dasharray:8 3}"
           "svg .curve{stroke:var(--curve);stroke-width:2.6}"
           "svg .curve.second{stroke-dasharray:7 4}"
           "svg .dot{fill:var(--paper);stroke:var(--soft);stroke-width:1.6}"
           "svg .dot.control{fill:var(--soft);stroke:none}"
           "svg .dot.result{fill:var(--result);stroke:var(--paper)}"
           "svg .dot.second{fill:var(--second);stroke:var(--paper)}"
           "svg .label.result{fill:var(--result);font-weight:600}"
           "svg .label.second{fill:var(--second);font-weight:600}"
           "svg .arrow{stroke:var(--faint);stroke-width:1.2}"
           "svg .node{fill:var(--tint);stroke:none}"
           "svg .node.left{stroke:var(--result);stroke-width:2}"
           "svg .node.right{stroke:var(--second);stroke-width:2;stroke-dasharray:6 3}"
           "svg .node.left.right{stroke-dasharray:none;stroke-width:3}"
           "svg .value{font-weight:600;stroke:none}svg .name{stroke:none;fill:var(--soft)}"
           ":root{--ink:#1b1b1b;--paper:#ffffff;--soft:#565656;--faint:#8d8d8d;--tint:#f3f1ec;"
           "--curve:#0b5394;--result:#a3241d;--second:#1c6b34}"
           "@media (prefers-color-scheme:dark){:root{--ink:#ececec;--paper:#16181b;--soft:#b4b4b4;"
           "--faint:#808080;--tint:#24272c;--curve:#8ec5ff;--result:#ff9b8f;--second:#8bdca0}}";
}

std::string render_svg(const Picture& picture, const Notation& notation) {
    pugi::xml_document document;
    pugi::xml_node svg = append_picture(document.root(), picture, notation, 1);
    // A file that is shown as an image has the reader's scheme but no page: its paper is its own.
    svg.insert_child_after("style", svg.child("desc") ? svg.child("desc") : svg.child("title"))
        .text()
        .set((svg_style() + "svg{background:var(--paper)}").c_str());
    return markup_of(document) + "\n";
}

}  // namespace blossom::worked
