#include <blossom/worked/render.hpp>

#include <algorithm>
#include <functional>

#include "document/layout.hpp"
#include "document/letters.hpp"
#include "document/overloaded.hpp"
#include "pyramid_text.hpp"

namespace blossom::worked {

namespace {

class Printer {
public:
    Printer(const Notation& notation, std::size_t width) : notation_(notation), width_(width) {}

    static constexpr const char* before_block = "";

    std::string title(const std::string& words) const { return underlined(words, '='); }
    std::string source(const std::string& words) const {
        return wrapped("Source: " + words, width_) + "\n\n";
    }
    std::string heading(const std::string& words) const { return underlined(words, '-'); }
    static std::string closing(const std::string& words) { return words; }

    std::string block(const Paragraph& paragraph) const {
        return wrapped(line(paragraph.text), width_) + "\n";
    }
    std::string block(const Display& display) const { return formulas(display.formulas); }
    std::string block(const Table& table) const {
        return wrapped(table.caption, width_) + "\n\n" + table_text(table);
    }
    std::string block(const TrianglePyramid& pyramid) const {
        return wrapped(pyramid.caption, width_) + "\n\n" + pyramid_text(pyramid, notation_, width_);
    }
    std::string block(const Picture& picture) const { return picture_text(picture); }

private:
    std::string underlined(const std::string& title, char mark) const {
        return wrapped(title, width_) + "\n" + std::string(std::min(columns(title), width_), mark) + "\n\n";
    }

    std::string line(const Text& text) const {
        return written(text, std::identity(),
                       [&](const Formula& formula) { return to_text(formula, notation_); });
    }

    std::string formulas(const std::vector<Formula>& list) const {
        std::string text;
        for (const Formula& formula : list) text += "  " + formula_lines(formula) + "\n";
        return text;
    }

    /// On one line where it fits, otherwise a line for each side, and more where a side is too long.
    std::string formula_lines(const Formula& formula) const {
        std::string whole = to_text(formula, notation_);
        if (columns(whole) + 2 <= width_) return whole;
        std::vector<std::vector<std::string>> sides;
        for (const Piece& piece : pieces_of(formula, notation_)) {
            if (sides.empty() || piece.begins_side) sides.emplace_back();
            std::string text = text_of(piece.layout);
            text.erase(0, text.find_first_not_of(' '));
            sides.back().push_back(std::move(text));
        }
        const std::size_t left = sides.front().size() == 1 ? columns(sides.front().front()) : 0;
        const std::size_t indent = left < width_ / 3 ? left + 3 : 6;
        std::string text = wrapped(sides.front(), width_ - 2, 4);
        for (std::size_t i = 1; i < sides.size(); ++i) {
            text += i == 1 && indent == left + 3 ? " " : "\n" + std::string(indent, ' ');
            text += wrapped(sides[i], width_ - indent, indent + 2);
        }
        return text;
    }

    std::string table_text(const Table& table) const {
        std::vector<std::vector<std::string>> rows(1);
        for (const Text& title : table.header) rows.front().push_back(line(title));
        for (const auto& cells : table.rows) {
            std::vector<std::string>& row = rows.emplace_back();
            for (const Cell& cell : cells) row.push_back(line(cell.shown));
        }
        return fitting(rows);
    }

    /// Rows below each other, or where they are too wide each cell on a line of its own behind its title.
    std::string fitting(const std::vector<std::vector<std::string>>& rows) const {
        std::string text = text_table(rows);
        if (widest_line(text) <= width_) return text;
        text.clear();
        for (std::size_t i = 1; i < rows.size(); ++i) {
            for (std::size_t j = 0; j < rows[i].size(); ++j) {
                const std::string& title = rows.front()[j];
                const std::string entry = title.empty() ? rows[i][j] : title + ": " + rows[i][j];
                text += (j == 0 ? "  " : "    ") + wrapped(entry, width_ - 4, 6) + "\n";
            }
        }
        return text;
    }

    std::string picture_text(const Picture& picture) const {
        std::string text = wrapped(picture.caption + " " + picture.description, width_) + "\n";
        // Arguments, not values, have no coordinates that mean anything.
        if (!picture.corners.empty()) return text;
        text += "\n";
        std::vector<std::vector<std::string>> rows{{"point", "x", "y"}};
        for (const PicturePoint& point : picture.points) {
            rows.push_back({to_text(point.label, notation_), to_text(number(point.place.x)),
                            to_text(number(point.place.y))});
        }
        return text + fitting(rows);
    }

    const Notation& notation_;
    std::size_t width_;
};

}  // namespace

std::string render_text(const Document& document, const Notation& notation, std::size_t width) {
    Printer printer(notation, std::max<std::size_t>(width, 20));
    return written(document, printer);
}

}  // namespace blossom::worked
