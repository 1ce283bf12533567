#include <algorithm>
#include <string>
#include <vector>

#include "svg.hpp"

namespace blossom::worked {

namespace {

constexpr Length pitch = 330;  ///< half the distance of two nodes of a level
constexpr Length node_height = 430;
constexpr Length padding = 80;
constexpr Length least_gap = 520;
constexpr Length margin = 30;

/// Where the nodes of one level stand.
struct Column {
    Length left = 0;
    Length width = 0;
};

class PyramidDrawing {
public:
    PyramidDrawing(const TrianglePyramid& pyramid, const Notation& notation)
        : pyramid_(pyramid),
          notation_(notation),
          height_(2 * pitch * static_cast<Length>(pyramid.levels.front().size() - 1) + node_height +
                  2 * margin) {
        Length left = margin;
        for (const auto& level : pyramid.levels) {
            Column column{left, 0};
            Length gap = least_gap;
            for (const PyramidNode& node : level) {
                const Length width =
                    std::max(text_width(text(node.label)), text_width(text(node.value), true));
                column.width = std::max(column.width, width + padding);
                for (const auto& weight : {node.left_weight, node.right_weight}) {
                    if (weight) gap = std::max(gap, text_width(text(*weight)) + 240);
                }
            }
            if (!columns_.empty()) column.left += gap;
            left = column.left + column.width;
            columns_.push_back(column);
        }
        width_ = left + margin;
    }

    Length width() const { return width_; }
    Length height() const { return height_; }

    void append_to(pugi::xml_node svg) const {
        for (std::size_t r = 1; r < columns_.size(); ++r) {
            for (std::size_t i = 0; i < pyramid_.levels[r].size(); ++i) {
                const PyramidNode& node = pyramid_.levels[r][i];
                append_arrow(svg, r, i, i, node.left_weight);
                append_arrow(svg, r, i, i + 1, node.right_weight);
            }
        }
        for (std::size_t r = 0; r < columns_.size(); ++r) {
            for (std::size_t i = 0; i < pyramid_.levels[r].size(); ++i) append_node(svg, r, i);
        }
    }

private:
    std::string text(const Formula& formula) const { return to_text(formula, notation_); }

    static Length middle(std::size_t level, std::size_t i) {
        return margin + node_height / 2 + pitch * static_cast<Length>(2 * i + level);
    }

    void append_arrow(pugi::xml_node svg, std::size_t level, std::size_t i, std::size_t from,
                      const std::optional<Formula>& weight) const {
        if (!weight) return;
        const Column& before = columns_[level - 1];
        const Segment arrow{{before.left + before.width, middle(level - 1, from)},
                            {columns_[level].left, middle(level, i)}};
        append_line(svg, arrow, "arrow");
        append_label(svg, {(arrow.begin.x + arrow.end.x) / 2, (arrow.begin.y + arrow.end.y) / 2}, "middle",
                     "weight", text(*weight));
    }

    void append_node(pugi::xml_node svg, std::size_t level, std::size_t i) const {
        const PyramidNode& node = pyramid_.levels[level][i];
        const Column& column = columns_[level];
        const Length y = middle(level, i);
        append(svg, "rect",
               {{"x", pixels(column.left)},
                {"y", pixels(y - node_height / 2)},
                {"width", pixels(column.width)},
                {"height", pixels(node_height)},
                {"rx", "5"},
                {"class", std::string("node") + (node.on_left_edge ? " left" : "") +
                              (node.on_right_edge ? " right" : "")}});
        const Length centre = column.left + column.width / 2;
        append_label(svg, {centre, y - 95}, "middle", "name", text(node.label));
        append_label(svg, {centre, y + 95}, "middle", "value", text(node.value));
    }

    const TrianglePyramid& pyramid_;
    const Notation& notation_;
    std::vector<Column> columns_;
    Length width_ = 0;
    Length height_ = 0;
};

}  // namespace

pugi::xml_node append_pyramid(pugi::xml_node parent, const TrianglePyramid& pyramid, const Notation& notation,
                              std::size_t number) {
    const PyramidDrawing drawing(pyramid, notation);
    pugi::xml_node svg = append_svg(
        parent, drawing.width(), drawing.height(), "pyramid" + std::to_string(number), pyramid.caption,
        "A triangle of values, one column a level; each is made of its two neighbours on the left.");
    svg.append_attribute("class") = "pyramid";
    drawing.append_to(svg);
    return svg;
}

}  // namespace blossom::worked
