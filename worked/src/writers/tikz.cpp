#include "tikz.hpp"

#include <algorithm>
#include <string>

#include "drawing/drawing.hpp"

namespace blossom::worked {

namespace {

/// A place in units of a pixel, y upwards.
std::string coordinate(const Spot& spot) { return "(" + pixels(spot.x) + "," + pixels(-spot.y) + ")"; }

std::string line(const Segment& segment, const std::string& style) {
    return "\\draw[" + style + "] " + coordinate(segment.begin) + " -- " + coordinate(segment.end) + ";\n";
}

std::string path(const Drawing::Path& path) {
    std::string text = std::string("\\draw[blossom ") + (path.is_curve ? "curve" : "line") + " " +
                       role_name(path.role) + "] " + coordinate(path.spots.front());
    for (std::size_t i = 1; i < path.spots.size(); ++i) {
        if (!path.cubic) {
            text += " -- " + coordinate(path.spots[i]);
        } else {
            constexpr const char* words[] = {" .. controls ", " and ", " .. "};
            text += words[(i - 1) % 3] + coordinate(path.spots[i]);
        }
        if (i % 6 == 0) text += "\n ";
    }
    return text + ";\n";
}

std::string node(const Spot& spot, const std::string& style, const std::string& text) {
    return "\\node[" + style + "] at " + coordinate(spot) + " {" + text + "};\n";
}

std::string axes(const Drawing& drawing) {
    std::string text;
    for (const Segment& axis : drawing.axes) text += line(axis, "blossom axis");
    for (const Drawing::Tick& tick : drawing.ticks) {
        const Spot& spot = tick.across.begin;
        const Spot end = tick.horizontal ? Spot{spot.x, spot.y + 40} : Spot{spot.x - 40, spot.y};
        text += line({spot, end}, "blossom axis") +
                node(end, std::string("blossom number,") + (tick.horizontal ? "below" : "left"),
                     "$" + tick.text + "$");
    }
    return text;
}

}  // namespace

std::string tikz_styles() {
    return "\\definecolor{blossomcurve}{HTML}{0B5394}\n"
           "\\definecolor{blossomresult}{HTML}{A3241D}\n"
           "\\definecolor{blossomsecond}{HTML}{1C6B34}\n"
           "\\tikzset{\n"
           "  blossom line/.style={line width=.5pt},\n"
           "  blossom line control/.style={line width=.6pt,gray,dash pattern=on 4pt off 2.5pt},\n"
           "  blossom line construction/.style={line width=.5pt,gray},\n"
           "  blossom line result/.style={line width=.9pt,blossomresult},\n"
           "  blossom line second/.style={line width=.9pt,blossomsecond,dash pattern=on 5pt off 2pt},\n"
           "  blossom curve control/.style={line width=1.2pt,blossomcurve},\n"
           "  blossom curve construction/.style={line width=1.2pt,blossomcurve},\n"
           "  blossom curve result/.style={line width=1.2pt,blossomcurve},\n"
           "  blossom curve second/.style={line width=1.2pt,blossomcurve,dash pattern=on 4pt off 2pt},\n"
           "  blossom dot control/.style={fill=gray},\n"
           "  blossom dot construction/.style={draw=gray,fill=white},\n"
           "  blossom dot result/.style={fill=blossomresult},\n"
           "  blossom dot second/.style={fill=blossomsecond},\n"
           "  blossom axis/.style={line width=.4pt,gray},\n"
           "  blossom leader/.style={line width=.3pt,gray,densely dotted},\n"
           "  blossom number/.style={font=\\scriptsize,gray,inner sep=2pt},\n"
           "  blossom label/.style={font=\\footnotesize,inner sep=0pt,outer sep=0pt},\n"
           "  blossom node/.style={draw=black!15,fill=black!4,rounded corners=1.5pt,inner sep=3pt,"
           "align=center,font=\\footnotesize},\n"
           "  blossom node left/.style={draw=blossomresult,line width=.9pt},\n"
           "  blossom node right/.style={draw=blossomsecond,line width=.9pt,dash pattern=on 3pt off 1.5pt},\n"
           "  blossom arrow/.style={line width=.4pt,gray},\n"
           "  blossom weight/.style={font=\\scriptsize,fill=white,inner sep=1pt},\n"
           "}\n";
}

std::string tikz_picture(const Picture& picture, const Notation& notation) {
    const Drawing drawing = drawn(picture, notation);
    std::string text = "\\begin{tikzpicture}[x=.62pt,y=.62pt]\n" + axes(drawing);
    for (const Drawing::Path& one : drawing.paths) text += path(one);
    for (const Drawing::Label& label : drawing.labels) {
        if (label.leader) text += line(*label.leader, "blossom leader");
    }
    for (const Drawing::Dot& dot : drawing.dots) {
        text += "\\path[blossom dot " + role_name(dot.role) + "] " + coordinate(dot.spot) +
                " circle[radius=" + (dot.role >= Role::result ? "2.2pt" : "1.7pt") + "];\n";
    }
    for (const Drawing::Label& label : drawing.labels) {
        const Spot middle{(label.box.left + label.box.right) / 2, (label.box.top + label.box.bottom) / 2};
        text += node(middle, "blossom label", "$" + to_latex(label_formula(label), notation) + "$");
    }
    return text + "\\end{tikzpicture}";
}

std::string tikz_pyramid(const TrianglePyramid& pyramid, const Notation& notation) {
    std::string nodes;
    std::string arrows;
    for (std::size_t r = 0; r < pyramid.levels.size(); ++r) {
        for (std::size_t i = 0; i < pyramid.levels[r].size(); ++i) {
            const PyramidNode& one = pyramid.levels[r][i];
            const auto name = [](std::size_t level, std::size_t place) {
                return "n" + std::to_string(level) + "-" + std::to_string(place);
            };
            const Length y = -static_cast<Length>(2 * i + r) * 5;
            nodes += std::string("\\node[blossom node") + (one.on_left_edge ? ",blossom node left" : "") +
                     (one.on_right_edge ? ",blossom node right" : "") + "] (" + name(r, i) + ") at (" +
                     std::to_string(r) + "," + pixels(y) + ") {$" + to_latex(one.label, notation) + "$\\\\$" +
                     to_latex(one.value, notation) + "$};\n";
            const auto arrow = [&](std::size_t from, const std::optional<Formula>& weight) {
                if (!weight) return;
                arrows += "\\draw[blossom arrow] (" + name(r - 1, from) +
                          ".east) -- node[blossom weight] {$" + to_latex(*weight, notation) + "$} (" +
                          name(r, i) + ".west);\n";
            };
            arrow(i, one.left_weight);
            arrow(i + 1, one.right_weight);
        }
    }
    Length widest = 0;
    for (const auto& level : pyramid.levels) {
        for (const PyramidNode& one : level) {
            widest = std::max(
                {widest, text_width(to_text(one.label, notation)), text_width(to_text(one.value, notation))});
        }
    }
    // A column is as wide as the widest node, and the arrows between need room for their weights.
    return "\\begin{tikzpicture}[x=" + pixels(widest * 5 / 10 + 520) + "pt,y=32pt]\n" + nodes + arrows +
           "\\end{tikzpicture}";
}

}  // namespace blossom::worked
