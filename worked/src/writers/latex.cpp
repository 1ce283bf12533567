#include <blossom/worked/render.hpp>

#include <string>

#include "document/layout.hpp"
#include "document/letters.hpp"
#include "document/overloaded.hpp"
#include "latex_words.hpp"
#include "tikz.hpp"

namespace blossom::worked {

namespace {

/// About how many letters of a formula fit on a line.
constexpr std::size_t line_letters = 62;

class LatexWriter {
public:
    explicit LatexWriter(const Notation& notation) : notation_(notation) {}

    static constexpr const char* before_block = "\n";

    static std::string title(const std::string& words) { return "\\section*{" + latex_text(words) + "}\n"; }
    static std::string source(const std::string& words) {
        return "\n{\\small Source: " + latex_text(words) + ".\\par}\n";
    }
    static std::string closing(const std::string& words) { return "\n" + latex_text(words); }
    static std::string heading(const std::string& title) {
        return "\n\\subsection*{" + latex_text(title) + "}\n";
    }

    std::string block(const Paragraph& paragraph) const { return words(paragraph.text) + "\\par"; }

    /// Formulas that fit stand aligned below each other, one side a line; TeX breaks the others at their
    /// signs.
    std::string block(const Display& display) const {
        std::string text;
        std::string rows;
        for (const Formula& formula : display.formulas) {
            const std::string more = aligned(formula);
            if (!more.empty()) {
                rows += (rows.empty() ? "" : "\\\\[.4ex]\n") + more;
                continue;
            }
            text += alignment(rows) + in_lines(formula) + "\n";
            rows.clear();
        }
        return text + alignment(rows);
    }

    static std::string alignment(const std::string& rows) {
        return rows.empty() ? "" : "\\begin{align*}\n" + rows + "\n\\end{align*}\n";
    }

    /// The lines of an alignment, or "" for what has no sides or is too long.
    std::string aligned(const Formula& formula) const {
        if (formula.kind != FormulaKind::relation) return "";
        const std::size_t left = columns(to_text(formula.parts.front(), notation_));
        std::string rows = to_latex(formula.parts.front(), notation_);
        for (std::size_t i = 1; i < formula.parts.size(); ++i) {
            if (left + columns(to_text(formula.parts[i], notation_)) > line_letters) return "";
            rows += std::string(i == 1 ? "" : "\\\\\n") + " &" + latex_sign(formula.name) + " " +
                    to_latex(formula.parts[i], notation_);
        }
        return rows;
    }

    std::string in_lines(const Formula& formula) const {
        return "\\begin{blossomformula}$" + to_latex(formula, notation_) + "$\\end{blossomformula}";
    }

    std::string block(const Table& table) const {
        std::string text = figure_caption(table.caption) + "\\blossomfit{\\begin{tabular}{" +
                           std::string(table.header.size(), 'l') + "}\\hline\n";
        for (std::size_t j = 0; j < table.header.size(); ++j)
            text += (j ? " & " : "") + words(table.header[j]);
        text += " \\\\\\hline\n";
        for (const auto& row : table.rows) {
            for (std::size_t j = 0; j < row.size(); ++j) text += (j ? " & " : "") + words(row[j].shown);
            text += " \\rule[-1.1ex]{0pt}{3.4ex}\\\\\n";
        }
        return text + R"(\hline\end{tabular}}\par\medskip)";
    }

    std::string block(const TrianglePyramid& pyramid) const {
        return figure(tikz_pyramid(pyramid, notation_), pyramid.caption);
    }

    std::string block(const Picture& picture) const {
        return figure(tikz_picture(picture, notation_), picture.caption);
    }

    static std::string figure(const std::string& drawing, const std::string& caption) {
        return figure_caption(caption) + "\\blossomfit{" + drawing + "}\\par\\medskip";
    }

    static std::string figure_caption(const std::string& caption) {
        return R"(\medskip\noindent{\small )" + latex_text(caption) +
               R"(}\par\nopagebreak\smallskip\noindent)";
    }

    std::string words(const Text& text) const { return latex_words(text, notation_); }

    const Notation& notation_;
};

}  // namespace

std::string latex_words(const Text& text, const Notation& notation) {
    return written(text, latex_text,
                   [&](const Formula& formula) { return "$" + to_latex(formula, notation) + "$"; });
}

std::string latex_preamble() {
    return "\\usepackage[T1]{fontenc}\n"
           "\\usepackage[utf8]{inputenc}\n"
           "\\usepackage{lmodern}\n"
           "\\usepackage{amsmath}\n"
           "\\usepackage{graphicx}\n"
           "\\usepackage{tikz}\n" +
           tikz_styles() +
           "% Formulas within words break nowhere; the spaces between give way.\n"
           "\\emergencystretch=3em\n"
           "% What is wider than the line is scaled down to it.\n"
           "\\newsavebox{\\blossombox}\n"
           "\\newcommand{\\blossomfit}[1]{\\sbox{\\blossombox}{#1}%\n"
           "  \\ifdim\\wd\\blossombox>\\linewidth\\resizebox{\\linewidth}{!}{\\usebox{\\blossombox}}%\n"
           "  \\else\\usebox{\\blossombox}\\fi}\n"
           "% A formula that TeX may break at its signs.\n"
           "\\newenvironment{blossomformula}{"
           "\\par\\smallskip\\begingroup\\raggedright\\leftskip2em\\parindent0pt\n"
           "  \\relpenalty50\\binoppenalty100\\hangindent2em\\noindent}{\\par\\endgroup\\smallskip}\n";
}

std::string render_latex_fragment(const Document& document, const Notation& notation) {
    LatexWriter writer(notation);
    return written(document, writer);
}

std::string render_latex(std::span<const Document> documents, const Notation& notation) {
    std::string body;
    for (const Document& document : documents) body += render_latex_fragment(document, notation);
    return "\\documentclass[11pt,a4paper,fleqn]{article}\n" + latex_preamble() +
           "\\setlength{\\parindent}{0pt}\\setlength{\\parskip}{.5ex plus "
           ".3ex}\n\\allowdisplaybreaks\\raggedbottom\n"
           "\\begin{document}\n" +
           body + "\\end{document}\n";
}

}  // namespace blossom::worked
