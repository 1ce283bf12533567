#include "renaming.hpp"

#include <algorithm>

namespace blossom::worked {

namespace {

class Renaming {
public:
    Renaming(const Document& document, std::string index)
        : symbols_(document.symbols), index_(std::move(index)) {
        for (const NamedMap& map : document.maps) {
            names_.push_back(map.map);
            names_.push_back(map.blossom);
        }
        for (const NamedPoint& point : document.points) {
            if (!is_vertex(point)) symbols_.push_back(point.name);
        }
    }

    /// Vertices are called the same in every problem.
    static bool is_vertex(const NamedPoint& point) {
        return std::ranges::count(point.barycentric, Rational(1)) == 1 &&
               std::ranges::count(point.barycentric, Rational(0)) == 2;
    }

    void apply(NamedPoint& point) const {
        if (!is_vertex(point)) point.name += index_;
    }

    void apply(std::string& name) const {
        if (std::ranges::find(names_, name) != names_.end()) name += index_;
    }

    void apply(Formula& formula) const {
        const bool named = std::ranges::find(symbols_, formula.name) != symbols_.end();
        if (formula.kind == FormulaKind::symbol && named) {
            formula = symbol(formula.name + index_);
            return;
        }
        if (formula.kind != FormulaKind::symbol && formula.kind != FormulaKind::words) apply(formula.name);
        for (Formula& part : formula.parts) apply(part);
    }

    void apply(Text& text) const {
        Text renamed;
        for (Text::Part part : text.parts()) {
            if (auto* formula = std::get_if<Formula>(&part)) apply(*formula);
            renamed.append(Text{std::move(part)});
        }
        text = std::move(renamed);
    }

    void apply(Blocks& blocks) const {
        for (Block& block : blocks) std::visit([&](auto& content) { apply(content); }, block);
    }

    void apply(Paragraph& paragraph) const { apply(paragraph.text); }

    void apply(Display& display) const {
        for (Formula& formula : display.formulas) apply(formula);
    }

    void apply(Table& table) const {
        for (Text& title : table.header) apply(title);
        for (auto& row : table.rows) {
            for (Cell& cell : row) {
                apply(cell.shown);
                if (cell.meaning) apply(*cell.meaning);
            }
        }
    }

    void apply(TrianglePyramid& pyramid) const {
        for (auto& level : pyramid.levels) {
            for (PyramidNode& node : level) apply(node.label);
        }
    }

    void apply(Picture& picture) const {
        for (PicturePoint& point : picture.points) {
            apply(point.label);
            if (point.meaning) apply(*point.meaning);
        }
    }

private:
    std::vector<std::string> names_;
    std::vector<std::string> symbols_;
    std::string index_;
};

}  // namespace

Document renamed(Document document, const std::string& index) {
    const Renaming renaming(document, index);
    for (NamedMap& map : document.maps) {
        renaming.apply(map.map);
        renaming.apply(map.blossom);
    }
    for (NamedPoint& point : document.points) renaming.apply(point);
    renaming.apply(document.statement);
    for (Step& step : document.steps) renaming.apply(step.blocks);
    renaming.apply(document.result);
    if (document.check) renaming.apply(document.check->blocks);
    return document;
}

}  // namespace blossom::worked
