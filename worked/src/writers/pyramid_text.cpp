#include "pyramid_text.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "document/letters.hpp"

namespace blossom::worked {

namespace {

/// What marks a point of a result.
std::string marks(const PyramidNode& node) {
    return std::string(node.on_left_edge ? " ◂" : "") + (node.on_right_edge ? " ▸" : "");
}

/// "p(0, 0, 1) = 5/3".
std::string node_text(const PyramidNode& node, const Notation& notation) {
    return to_text(equation({node.label, node.value}), notation) + marks(node);
}

bool fits(const std::vector<std::string>& lines, std::size_t width) {
    return std::ranges::none_of(lines, [&](const std::string& line) { return columns(line) + 2 > width; });
}

/// A grid of texts whose columns are made as wide as they need to be.
class Grid {
public:
    Grid(std::size_t rows, std::size_t columns) : cells_(rows, std::vector<std::string>(columns)) {}

    std::string& at(std::size_t row, std::size_t column) { return cells_[row][column]; }

    std::vector<std::string> lines() const {
        std::vector<std::string> lines(cells_.size());
        for (std::size_t j = 0; j < cells_.front().size(); ++j) {
            std::size_t width = 0;
            for (const auto& row : cells_) width = std::max(width, columns(row[j]));
            for (std::size_t i = 0; i < cells_.size(); ++i) lines[i] += padded(cells_[i][j], width);
        }
        for (std::string& line : lines) line.erase(line.find_last_not_of(' ') + 1);
        return lines;
    }

private:
    std::vector<std::vector<std::string>> cells_;
};

/// With `stacked` values stand below their labels, which takes fewer columns.
std::vector<std::string> in_columns(const TrianglePyramid& pyramid, const Notation& notation, bool stacked) {
    const std::size_t levels = pyramid.levels.size();
    Grid grid(4 * levels - 3 + (stacked ? 1 : 0), 2 * levels - 1);
    for (std::size_t r = 0; r < levels; ++r) {
        for (std::size_t i = 0; i < pyramid.levels[r].size(); ++i) {
            const PyramidNode& node = pyramid.levels[r][i];
            const std::size_t row = 4 * i + 2 * r;
            grid.at(row, 2 * r) = stacked ? to_text(node.label, notation) : node_text(node, notation);
            if (stacked) grid.at(row + 1, 2 * r) = "= " + to_text(node.value, notation) + marks(node);
            if (r == 0) continue;
            if (node.left_weight) grid.at(row - 1, 2 * r - 1) = " ╲ " + to_text(*node.left_weight, notation);
            if (node.right_weight)
                grid.at(row + 1, 2 * r - 1) = " ╱ " + to_text(*node.right_weight, notation);
            grid.at(row, 2 * r - 1) = "   ";
        }
    }
    return grid.lines();
}

std::string by_levels(const TrianglePyramid& pyramid, const Notation& notation, std::size_t width) {
    std::string text;
    for (std::size_t r = 0; r < pyramid.levels.size(); ++r) {
        text += "  level " + std::to_string(r) + "\n";
        for (std::size_t i = 0; i < pyramid.levels[r].size(); ++i) {
            text += "    " + wrapped(to_text(node_equation(pyramid, r, i), notation), width - 4, 6) + "\n";
        }
    }
    return text;
}

Formula weighted(const Formula& weight, const Formula& label) {
    return weight == number(1) ? label : product({weight, label});
}

}  // namespace

Formula node_equation(const TrianglePyramid& pyramid, std::size_t level, std::size_t i) {
    const PyramidNode& node = pyramid.levels[level][i];
    if (level == 0 || !node.left_weight || !node.right_weight) return equation({node.label, node.value});
    const std::vector<PyramidNode>& before = pyramid.levels[level - 1];
    std::vector<Formula> terms;
    for (const auto& [weight, label] : {std::pair(*node.left_weight, before[i].label),
                                        std::pair(*node.right_weight, before[i + 1].label)}) {
        if (weight != number(0)) terms.push_back(weighted(weight, label));
    }
    Formula made = sum(std::move(terms));
    // With weights 0 and 1 a node is a neighbour.
    if (made == node.label) return equation({node.label, node.value});
    return equation({node.label, std::move(made), node.value});
}

std::string pyramid_text(const TrianglePyramid& pyramid, const Notation& notation, std::size_t width) {
    std::vector<std::string> lines = in_columns(pyramid, notation, false);
    if (!fits(lines, width)) lines = in_columns(pyramid, notation, true);
    if (!fits(lines, width)) return by_levels(pyramid, notation, width);
    std::string text;
    for (const std::string& line : lines) text += line.empty() ? "\n" : "  " + line + "\n";
    return text;
}

}  // namespace blossom::worked
