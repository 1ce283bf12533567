#include <algorithm>
#include <string_view>

#include "document/layout.hpp"
#include "document/letters.hpp"

namespace blossom::worked {

namespace {

using Kind = Layout::Kind;

bool are_numbers(const std::vector<Layout>& parts) {
    return std::ranges::all_of(parts, [](const Layout& part) { return part.kind == Kind::number; });
}

/// Whether fences around it must grow.
bool is_tall(const Layout& layout) {
    if (layout.kind == Kind::under || layout.kind == Kind::cases) return true;
    if (layout.kind == Kind::fraction || layout.kind == Kind::stack) return !are_numbers(layout.parts);
    const bool scripts = layout.kind == Kind::superscript || layout.kind == Kind::subscript;
    return scripts ? is_tall(layout.parts[0]) : std::ranges::any_of(layout.parts, is_tall);
}

std::string fenced_latex(const Layout& layout) {
    const std::string inside = latex_of(layout.parts[0]);
    if (layout.text == "⟨⟩") return "\\langle " + inside + "\\rangle";
    const bool braces = layout.text == "{}";
    const std::string open = braces ? "\\{" : layout.text.substr(0, 1);
    const std::string close = braces ? "\\}" : layout.text.substr(1);
    return is_tall(layout.parts[0]) ? "\\left" + open + inside + "\\right" + close : open + inside + close;
}

std::string braced(const Layout& layout) { return "{" + latex_of(layout) + "}"; }

}  // namespace

std::string latex_of(const Layout& layout) {
    const std::vector<Layout>& parts = layout.parts;
    switch (layout.kind) {
        case Kind::number:
            return layout.text;
        case Kind::identifier:
            return letter(layout.text).latex;
        case Kind::words:
            return "\\text{" + latex_text(layout.text) + "}";
        case Kind::relation:
        case Kind::binary:
            return " " + latex_sign(layout.text) + " ";
        case Kind::sign:
            return latex_sign(layout.text);
        case Kind::times:
            return "\\,";
        case Kind::apply:
            return "";
        case Kind::comma:
            return layout.text + " ";
        case Kind::fraction:
            // Numbers are small, also in a display; what has signs in it is not.
            return (are_numbers(parts) ? "\\tfrac" : "\\frac") + braced(parts[0]) + braced(parts[1]);
        case Kind::superscript:
            // Both scripts of a name stand above each other.
            return (parts[0].kind == Kind::subscript ? latex_of(parts[0]) : braced(parts[0])) + "^" +
                   braced(parts[1]);
        case Kind::subscript:
            return braced(parts[0]) + "_" + braced(parts[1]);
        case Kind::fenced:
            return fenced_latex(layout);
        case Kind::under:
            return latex_sign(parts[0].text) + "_" + braced(parts[1]) +
                   (parts.size() == 3 ? "^" + braced(parts[2]) : "") + " ";
        case Kind::cases:
            return "\\begin{cases} " + latex_of(parts[0]) + " & \\text{if } " + latex_of(parts[1]) +
                   " \\\\ " + latex_of(parts[2]) + " & \\text{otherwise} \\end{cases}";
        case Kind::stack:
            return (are_numbers(parts) ? "\\tbinom" : "\\binom") + braced(parts[0]) + braced(parts[1]);
        case Kind::row:
            break;
    }
    std::string text;
    for (const Layout& part : parts) text += latex_of(part);
    return text;
}

std::string to_latex(const Formula& formula, const Notation& notation) {
    return latex_of(layout_of(formula, notation));
}

}  // namespace blossom::worked
