#include <blossom/worked/render.hpp>

#include <algorithm>
#include <string>

#include "document/letters.hpp"
#include "document/overloaded.hpp"
#include "html_page.hpp"
#include "mathml.hpp"
#include "pyramid_text.hpp"
#include "svg.hpp"

namespace blossom::worked {

namespace {

/// The letters of a left side from which on, on a phone, the others stand below it.
constexpr std::size_t widest_left = 17;

class HtmlWriter {
public:
    explicit HtmlWriter(const Notation& notation) : notation_(notation) {}

    void write(pugi::xml_node main, const Document& document) {
        append_words(main, "h1", document.title);
        blocks(main, document.general);
        blocks(main, document.statement);
        if (!document.source.empty()) {
            append_words(main, "p", "Source: " + document.source).append_attribute("class") = "source";
        }
        for (std::size_t i = 0; i < document.steps.size(); ++i) {
            pugi::xml_node step = section(main, std::to_string(i + 1) + ". " + document.steps[i].title);
            blocks(step, document.steps[i].blocks);
        }
        if (!document.result.empty()) {
            pugi::xml_node result = section(main, "Result");
            result.append_attribute("class") = "result";
            blocks(result, document.result);
        }
        if (document.check) check(section(main, "Check"), *document.check);
    }

private:
    static pugi::xml_node section(pugi::xml_node main, const std::string& title) {
        pugi::xml_node node = main.append_child("section");
        append_words(node, "h2", title);
        return node;
    }

    void blocks(pugi::xml_node parent, const std::vector<Block>& list) {
        for (const Block& block : list) {
            std::visit(Overloaded{[&](const Paragraph& paragraph) {
                                      text(parent.append_child("p"), paragraph.text);
                                  },
                                  [&](const Display& display) { formulas(parent, display.formulas); },
                                  [&](const Table& table) { this->table(parent, table); },
                                  [&](const TrianglePyramid& pyramid) { this->pyramid(parent, pyramid); },
                                  [&](const Picture& picture) { this->picture(parent, picture); }},
                       block);
        }
    }

    void text(pugi::xml_node node, const Text& text) const {
        const std::vector<Text::Part>& parts = text.parts();
        std::size_t begun = 0;  ///< the bytes of the next words that stand behind a formula already
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (const auto* words = std::get_if<std::string>(&parts[i])) {
                node.append_child(pugi::node_pcdata).set_value(words->c_str() + begun);
                begun = 0;
                continue;
            }
            const Layout layout = layout_of(std::get<Formula>(parts[i]), notation_);
            const auto* next = i + 1 < parts.size() ? std::get_if<std::string>(&parts[i + 1]) : nullptr;
            begun = next ? std::min(next->find_first_not_of(".,;:?)"), next->size()) : 0;
            if (begun == 0) {
                append_math(node, layout);
                continue;
            }
            // A line does not begin with what ends a formula.
            pugi::xml_node together = node.append_child("span");
            together.append_attribute("class") = "together";
            append_math(together, layout);
            together.append_child(pugi::node_pcdata).set_value(next->substr(0, begun).c_str());
        }
    }

    /// One row of a grid for each side after the first, which stands in front; each may wrap at its signs.
    void formulas(pugi::xml_node parent, const std::vector<Formula>& list) const {
        for (const Formula& formula : list) {
            pugi::xml_node chain = parent.append_child("div");
            const bool chained = formula.kind == FormulaKind::relation;
            const bool long_left =
                chained && columns(to_text(formula.parts.front(), notation_)) > widest_left;
            chain.append_attribute("class") = long_left ? "formula long" : "formula";
            pugi::xml_node side;
            for (const Piece& piece : pieces_of(formula, notation_)) {
                if (!side || piece.begins_side) {
                    const bool first = !side;
                    side = chain.append_child("div");
                    side.append_attribute("class") = first ? "left" : "right";
                } else {
                    // A line may end here; the sign that follows has its own space on both sides.
                    side.append_child(pugi::node_pcdata).set_value("\u200b");
                }
                append_math(side, piece.layout, true);
            }
        }
    }

    void table(pugi::xml_node parent, const Table& table) const {
        pugi::xml_node figure = parent.append_child("figure");
        append_words(figure, "figcaption", table.caption);
        pugi::xml_node node = scroller(figure, table.caption).append_child("table");
        pugi::xml_node row = node.append_child("thead").append_child("tr");
        for (const Text& title : table.header) {
            pugi::xml_node cell = row.append_child("th");
            cell.append_attribute("scope") = "col";
            text(cell, title);
        }
        pugi::xml_node body = node.append_child("tbody");
        for (const auto& cells : table.rows) {
            row = body.append_child("tr");
            for (const Cell& cell : cells) text(row.append_child("td"), cell.shown);
        }
    }

    void pyramid(pugi::xml_node parent, const TrianglePyramid& pyramid) {
        pugi::xml_node figure = parent.append_child("figure");
        append_pyramid(scroller(figure, pyramid.caption), pyramid, notation_, ++figures_);
        append_words(figure, "figcaption", pyramid.caption);
        if (pyramid.levels.size() < 2) return;
        pugi::xml_node details = parent.append_child("details");
        append_words(details, "summary", "Every node written out");
        for (std::size_t r = 1; r < pyramid.levels.size(); ++r) {
            std::vector<Formula> equations;
            equations.reserve(pyramid.levels[r].size());
            for (std::size_t i = 0; i < pyramid.levels[r].size(); ++i) {
                equations.push_back(node_equation(pyramid, r, i));
            }
            formulas(details, equations);
        }
    }

    void picture(pugi::xml_node parent, const Picture& picture) {
        pugi::xml_node figure = parent.append_child("figure");
        append_picture(figure, picture, notation_, ++figures_);
        append_words(figure, "figcaption", picture.caption);
    }

    void check(pugi::xml_node node, const Check& check) {
        blocks(node, check.blocks);
        append_words(node, "p", said_of(check)).append_attribute("class") = check.holds ? "holds" : "fails";
    }

    /// What may be wider than a small screen scrolls by itself, also by the keyboard.
    static pugi::xml_node scroller(pugi::xml_node parent, const std::string& name) {
        pugi::xml_node node = parent.append_child("div");
        node.append_attribute("class") = "wide";
        node.append_attribute("role") = "region";
        node.append_attribute("tabindex") = "0";
        node.append_attribute("aria-label") = name.c_str();
        return node;
    }

    const Notation& notation_;
    std::size_t figures_ = 0;
};

}  // namespace

std::string render_html(std::span<const Document> documents, const Notation& notation,
                        const std::vector<Link>& links) {
    HtmlPage page(documents.front().title);
    page.append_navigation(links);
    HtmlWriter writer(notation);
    for (const Document& document : documents) writer.write(page.main(), document);
    return page.text();
}

}  // namespace blossom::worked
