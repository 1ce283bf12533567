#include <blossom/rational/lists.hpp>
#include <blossom/worked/general_statement.hpp>

#include <algorithm>
#include <numeric>

#include "document/layout.hpp"
#include "document/letters.hpp"
#include "writers/latex_words.hpp"

namespace blossom::worked {

namespace {

using Kind = Layout::Kind;

/// Widths are in tenths of a letter; about so much of a formula fits on a line of an article.
constexpr std::size_t line_width = 640;

const Notation brackets{BlossomStyle::brackets, false};

/// About how wide the formula is drawn.
std::size_t width_of(const Layout& layout) {
    const auto script = [](std::size_t width) { return width * 7 / 10; };
    std::vector<std::size_t> widths = mapped(layout.parts, width_of);
    switch (layout.kind) {
        case Kind::row:
            return std::accumulate(widths.begin(), widths.end(), std::size_t{0});
        case Kind::number:
        case Kind::identifier:
        case Kind::words:
            return 10 * columns(letter(layout.text).unicode);
        case Kind::relation:
        case Kind::binary:
            return 30;
        case Kind::sign:
            return 15;
        case Kind::apply:
        case Kind::times:
            return 0;
        case Kind::comma:
            return 10;
        case Kind::fraction:
        case Kind::stack:
            return *std::ranges::max_element(widths) + 10;
        case Kind::superscript:
        case Kind::subscript:
            return widths[0] + script(widths[1]);
        case Kind::fenced:
            return widths[0] + 20;
        case Kind::under:
            return std::max(std::size_t{25}, script(*std::max_element(widths.begin() + 1, widths.end())));
        case Kind::cases:
            return std::max(widths[0], widths[2]) + widths[1] + 80;
    }
    return 0;
}

/// On one line where it fits; otherwise a line for each side, and more where a side is too long. `ending`
/// stands behind it.
std::string display(const Formula& formula, const std::string& ending) {
    std::string one_line;
    std::string lines;
    std::size_t whole = 0;
    std::size_t line = 0;
    for (const Piece& piece : pieces_of(formula, brackets)) {
        const std::size_t width = width_of(piece.layout);
        const std::string text = latex_of(piece.layout);
        if (lines.empty()) {
            lines = "  &";
        } else if (piece.begins_side || line + width > line_width) {
            lines += piece.begins_side ? " \\\\\n  &\\quad" : " \\\\\n  &\\qquad";
            line = 40;
            // What stands in front makes the sign one between two parts.
            lines += " {}";
        }
        one_line += text;
        lines += text;
        whole += width;
        line += width;
    }
    if (whole <= line_width) return "\\[\n  " + one_line + ending + "\n\\]\n";
    return "\\begin{align*}\n" + lines + ending + "\n\\end{align*}\n";
}

std::string sentence(const Text& text) { return latex_words(text, brackets); }

/// The same, with long formulas on lines of their own; what ends them stands there too.
std::string sentences(const Text& text) {
    constexpr std::size_t most_inline = 320;
    std::string result;
    std::size_t begun = 0;  ///< the bytes of the next words that stand behind a formula already
    const std::vector<Text::Part>& parts = text.parts();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (const auto* words = std::get_if<std::string>(&parts[i])) {
            result += latex_text(std::string_view(*words).substr(begun));
            begun = 0;
            continue;
        }
        const auto& formula = std::get<Formula>(parts[i]);
        if (width_of(layout_of(formula, brackets)) <= most_inline) {
            result += sentence(formula);
            continue;
        }
        const auto* next = i + 1 < parts.size() ? std::get_if<std::string>(&parts[i + 1]) : nullptr;
        begun = next ? std::min(next->find_first_not_of(".,"), next->size()) : 0;
        if (result.ends_with(' ')) result.pop_back();
        result += "\n" + display(formula, next ? next->substr(0, begun) : "");
        if (next && next->substr(begun).starts_with(' ')) ++begun;
    }
    if (result.ends_with('\n')) result.pop_back();
    return result;
}

/// A title as the beginning of a paragraph, which ends with a stop.
std::string heading(const proofs::Block& block) {
    std::string title = block.title.empty() ? block.id : block.title;
    if (title.empty()) return "";
    if (title.find_last_of(".!?") != title.size() - 1) title += ".";
    return "\\textbf{" + latex_text(title) + "}\n";
}

}  // namespace

std::string render_latex_theorem(const proofs::Block& block, const std::vector<proofs::Decision>& decisions) {
    const Text declarations = declarations_in_words(block);
    // Formulas within words break nowhere: the spaces between them give way.
    std::string text = "{\\emergencystretch=3em\\noindent\n" + heading(block);
    if (!declarations.empty()) text += sentences(declarations) + "\n";
    std::string opening = declarations.empty() ? "" : "Then";
    for (const proofs::Decision& decision : decisions) {
        // Nothing is said to hold that was not decided so.
        const std::string claimed = opening.empty() ? "The claim is that" : opening + " the claim is that";
        const ClaimInWords claim = claim_in_words(block, block.statements[decision.statement],
                                                  decision.as_expected() ? opening : claimed);
        if (!claim.before.empty()) text += latex_text(claim.before) + "\n";
        text += display(claim.claim, claim.after.empty() ? "." : "");
        if (!claim.after.empty()) text += sentence(claim.after) + "\n";
        text += "\\emph{" + sentence(verdict_in_words(block, decision)) + "}\n";
        if (const auto* found = decision.counterexample())
            text += sentence(counterexample_in_words(*found)) + "\n";
        opening = "Moreover,";
    }
    return text + "\\par}\n";
}

}  // namespace blossom::worked
