#include <blossom/worked/render.hpp>

#include <string>

#include "document/overloaded.hpp"
#include "pyramid_text.hpp"

namespace blossom::worked {

namespace {

/// The columns of a pyramid drawn as text.
constexpr std::size_t drawn_width = 100;

class MarkdownWriter {
public:
    MarkdownWriter(const Notation& notation, const std::string& pictures)
        : notation_(notation), pictures_(pictures) {}

    static constexpr const char* before_block = "";

    static std::string title(const std::string& words) { return "# " + escaped(words) + "\n\n"; }
    static std::string source(const std::string& words) { return "Source: " + escaped(words) + "\n\n"; }
    static std::string heading(const std::string& words) { return "## " + escaped(words) + "\n\n"; }
    static std::string closing(const std::string& words) { return escaped(words); }

    std::string block(const Paragraph& paragraph) const { return words(paragraph.text) + "\n"; }

    std::string block(const Display& display) const {
        std::string text;
        for (const Formula& formula : display.formulas)
            text += "$$" + to_latex(formula, notation_) + "$$\n\n";
        text.pop_back();
        return text;
    }

    std::string block(const Table& table) const {
        std::string text = escaped(table.caption) + "\n\n|";
        for (const Text& title : table.header) text += " " + words(title) + " |";
        text += "\n|";
        for (std::size_t j = 0; j < table.header.size(); ++j) text += " --- |";
        text += "\n";
        for (const auto& row : table.rows) {
            text += "|";
            for (const Cell& cell : row) text += " " + words(cell.shown) + " |";
            text += "\n";
        }
        return text;
    }

    std::string block(const TrianglePyramid& pyramid) const {
        return escaped(pyramid.caption) + "\n\n```text\n" + pyramid_text(pyramid, notation_, drawn_width) +
               "```\n";
    }

    std::string block(const Picture& picture) {
        if (!pictures_.empty()) {
            return "![" + escaped(picture.description) + "](" + pictures_ + "-" + std::to_string(++shown_) +
                   ".svg)\n\n" + escaped(picture.caption) + "\n";
        }
        std::string text = escaped(picture.caption + " " + picture.description) + "\n";
        if (!picture.corners.empty()) return text;
        text += "\n| point | place |\n| --- | --- |\n";
        for (const PicturePoint& point : picture.points) {
            const Formula place = tuple({number(point.place.x), number(point.place.y)});
            text += "| $" + to_latex(point.label, notation_) + "$ | $" + to_latex(place, notation_) + "$ |\n";
        }
        return text;
    }

private:
    static std::string escaped(const std::string& words) {
        std::string text;
        for (const char c : words) {
            if (std::string_view("\\`*_{}[]<>#|$").find(c) != std::string_view::npos) text += '\\';
            text += c;
        }
        return text;
    }

    std::string words(const Text& text) const {
        return written(text, escaped,
                       [&](const Formula& formula) { return "$" + to_latex(formula, notation_) + "$"; });
    }

    const Notation& notation_;
    const std::string& pictures_;
    std::size_t shown_ = 0;
};

}  // namespace

std::string render_markdown(const Document& document, const Notation& notation, const std::string& pictures) {
    MarkdownWriter writer(notation, pictures);
    return written(document, writer);
}

std::vector<std::string> render_pictures(const Document& document, const Notation& notation) {
    std::vector<std::string> pictures;
    const auto add = [&](const std::vector<Block>& blocks) {
        for (const Block& block : blocks) {
            if (const auto* picture = std::get_if<Picture>(&block)) {
                pictures.push_back(render_svg(*picture, notation));
            }
        }
    };
    add(document.statement);
    for (const Step& step : document.steps) add(step.blocks);
    add(document.result);
    if (document.check) add(document.check->blocks);
    return pictures;
}

}  // namespace blossom::worked
