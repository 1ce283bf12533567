#include <blossom/rational/lists.hpp>
#include <blossom/worked/render.hpp>

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "mathml.hpp"
#include "svg.hpp"

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

void append_axes(pugi::xml_node svg, const Drawing& drawing, bool grid) {
    for (const Drawing::Tick& mark : drawing.ticks) {
        if (grid) append_line(svg, mark.across, "grid");
    }
    for (const Segment& axis : drawing.axes) append_line(svg, axis, "axis");
    for (const Drawing::Tick& mark : drawing.ticks) {
        const Spot& spot = mark.across.begin;
        if (mark.horizontal) {
            append_line(svg, {spot, {spot.x, spot.y + tick_length}}, "axis");
            append_label(svg, {spot.x, spot.y + 4 * tick_length}, "middle", "number", mark.text);
        } else {
            append_line(svg, {{spot.x - tick_length, spot.y}, spot}, "axis");
            append_label(svg, {spot.x - 2 * tick_length, spot.y}, "end", "number", mark.text);
        }
    }
}

void append_faces(pugi::xml_node svg, const Drawing& drawing) {
    using Edge = PictureFace::Edge;
    for (const auto& [spots, face] : drawing.faces) {
        std::string outline;
        std::string inner;
        std::string border;
        for (std::size_t k = 0; k < spots.size(); ++k) {
            outline += (k == 0 ? "" : " ") + coordinates(spots[k]);
            if (face.edges[k] == Edge::none) continue;
            (face.edges[k] == Edge::inner ? inner : border) +=
                "M" + coordinates(spots[k]) + " L" + coordinates(spots[(k + 1) % spots.size()]);
        }
        append(svg, "polygon",
               {{"points", outline}, {"fill", face.fill}, {"stroke", face.fill}, {"class", "face"}});
        if (!inner.empty()) append(svg, "path", {{"d", inner}, {"stroke", face.line}, {"class", "inner"}});
        if (!border.empty()) append(svg, "path", {{"d", border}, {"stroke", face.line}, {"class", "border"}});
    }
}

/// What was before lies behind all faces.
void append_paths(pugi::xml_node svg, const Drawing& drawing, bool before) {
    for (const Drawing::Path& path : drawing.paths) {
        if ((path.role == Role::before) != before) continue;
        append(
            svg, "path",
            {{"d", path_data(path)}, {"class", (path.is_curve ? "curve " : "line ") + role_name(path.role)}});
    }
    for (const Drawing::Label& label : drawing.labels) {
        if (label.leader && !before) append_line(svg, *label.leader, "leader");
    }
    for (const Drawing::Dot& dot : drawing.dots) {
        if ((dot.role == Role::before) != before) continue;
        append(svg, "circle",
               {{"cx", pixels(dot.spot.x)},
                {"cy", pixels(dot.spot.y)},
                {"r", dot.role >= Role::result ? "4.5" : "3.5"},
                {"class", "dot " + role_name(dot.role)}});
    }
}

void append_texts(pugi::xml_node svg, const Drawing& drawing, const Notation& notation) {
    for (std::size_t i = 0; i < drawing.labels.size(); ++i) {
        const Drawing::Label& label = drawing.labels[i];
        if (label.names.empty()) continue;
        append_label(svg, {(label.box.left + label.box.right) / 2, (label.box.top + label.box.bottom) / 2},
                     "middle", "label " + role_name(drawing.dots[i].role),
                     to_text(label_formula(label), notation));
    }
    for (const auto& [spot, words] : drawing.words) {
        const Spot place{spot.x + Length{10} * words.right, spot.y + Length{10} * words.below};
        const char* anchor = words.right == 0 ? "middle" : words.right > 0 ? "start" : "end";
        append_label(svg, place, anchor, "number", words.words);
    }
    for (const auto& [line, curve] : drawing.legend) {
        append_line(svg, line, "curve " + role_name(curve.role));
        append_label(svg, {line.end.x + 80, line.end.y}, "start", "number", curve.name);
    }
}

constexpr std::string_view svg_rules =
    "svg text{font:15px system-ui,'Segoe UI','DejaVu Sans',sans-serif;fill:var(--ink);"
    "paint-order:stroke;stroke:var(--paper);stroke-width:4px;stroke-linejoin:round}"
    "svg .number,svg .weight{font-size:13px;fill:var(--soft)}"
    "svg path{fill:none}"
    "svg .grid{stroke:var(--tint);stroke-width:1}"
    "svg .axis{stroke:var(--soft);stroke-width:1}"
    "svg .face{stroke-width:.6}svg .inner{stroke-width:.7}svg .border{stroke-width:1.6;stroke-linecap:round}"
    "svg .leader{stroke:var(--soft);stroke-width:.8;stroke-dasharray:2 2}"
    "svg .line{stroke:var(--faint);stroke-width:1.2}"
    "svg .line.before{stroke-dasharray:2 4}"
    "svg .line.control{stroke:var(--soft);stroke-width:1.6;stroke-dasharray:6 4}"
    "svg .line.result{stroke:var(--result);stroke-width:2}"
    "svg .line.second{stroke:var(--second);stroke-width:2;stroke-dasharray:8 3}"
    "svg .curve{stroke:var(--curve);stroke-width:2.6;stroke-linecap:round}"
    "svg .curve.before{stroke:var(--faint);stroke-width:7;stroke-opacity:.5}"
    "svg .curve.result{stroke:var(--result)}"
    "svg .curve.second{stroke:var(--second);stroke-dasharray:7 4}"
    "svg .dot{fill:var(--paper);stroke:var(--soft);stroke-width:1.6}"
    "svg .dot.before{stroke:var(--faint)}"
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
    "svg .value{font-weight:600;stroke:none}svg .name{stroke:none;fill:var(--soft)}";

struct Colour {
    std::string_view name;
    std::string_view light;
    std::string_view dark;
};
constexpr std::array<Colour, 8> colours{{{"--ink", "#1b1b1b", "#ececec"},
                                         {"--paper", "#ffffff", "#16181b"},
                                         {"--soft", "#565656", "#b4b4b4"},
                                         {"--faint", "#8d8d8d", "#808080"},
                                         {"--tint", "#f3f1ec", "#24272c"},
                                         {"--curve", "#0b5394", "#8ec5ff"},
                                         {"--result", "#a3241d", "#ff9b8f"},
                                         {"--second", "#1c6b34", "#8bdca0"}}};

std::string declared(std::string_view Colour::* scheme) {
    const auto text = [&](const Colour& colour) {
        return std::string(colour.name) + ":" + std::string(colour.*scheme);
    };
    return ":root{" + joined(colours, text, ";") + "}";
}

/// The rules with the colours in them, for programs that know no variables.
std::string coloured(std::string rules, std::string_view Colour::* scheme) {
    for (const Colour& colour : colours) {
        const std::string variable = "var(" + std::string(colour.name) + ")";
        for (std::size_t at = rules.find(variable); at != std::string::npos; at = rules.find(variable, at))
            rules.replace(at, variable.size(), colour.*scheme);
    }
    return rules;
}

constexpr const char* if_dark = "@media (prefers-color-scheme:dark){";

}  // namespace

pugi::xml_node append_picture(pugi::xml_node parent, const Picture& picture, const Notation& notation,
                              std::size_t number) {
    const Drawing drawing = drawn(picture, notation);
    pugi::xml_node svg = append_svg(parent, drawing.width, drawing.height, "picture" + std::to_string(number),
                                    picture.caption, picture.description);
    svg.append_attribute("class") = "picture";
    append_axes(svg, drawing, picture.grid);
    append_paths(svg, drawing, true);
    append_faces(svg, drawing);
    append_paths(svg, drawing, false);
    append_texts(svg, drawing, notation);
    return svg;
}

std::string svg_style() {
    return std::string(svg_rules) + declared(&Colour::light) + if_dark + declared(&Colour::dark) + "}";
}

std::string render_svg(const Picture& picture, const Notation& notation) {
    pugi::xml_document document;
    pugi::xml_node svg = append_picture(document.root(), picture, notation, 1);
    // A file that is shown as an image has the reader's scheme but no page: its paper is its own.
    const std::string rules = std::string(svg_rules) + "svg{background:var(--paper)}";
    svg.insert_child_after("style", svg.child("desc") ? svg.child("desc") : svg.child("title"))
        .text()
        .set((coloured(rules, &Colour::light) + if_dark + coloured(rules, &Colour::dark) + "}").c_str());
    return markup_of(document) + "\n";
}

}  // namespace blossom::worked
