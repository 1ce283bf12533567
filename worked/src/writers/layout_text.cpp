#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "document/layout.hpp"
#include "document/letters.hpp"

namespace blossom::worked {

namespace {

using Kind = Layout::Kind;

/// `text` in small raised or lowered characters, or "" when one of them has no such form.
std::string shifted(std::string_view text, std::string_view from, std::span<const std::string_view> to) {
    std::string result;
    for (const char c : text) {
        const std::size_t place = from.find(c);
        if (place == std::string_view::npos) return "";
        result += to[place];
    }
    return result;
}

std::string raised(std::string_view text) {
    static constexpr std::array<std::string_view, 13> signs{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶",
                                                            "⁷", "⁸", "⁹", "⁽", "⁾", "ⁿ"};
    return shifted(text, "0123456789()n", signs);
}

std::string lowered(std::string_view text) {
    static constexpr std::array<std::string_view, 13> signs{"₀", "₁", "₂", "₃", "₄", "₅", "₆",
                                                            "₇", "₈", "₉", "ᵢ", "ⱼ", "ₖ"};
    return shifted(text, "0123456789ijk", signs);
}

bool is_atom(const Layout& layout) {
    switch (layout.kind) {
        case Kind::number:
        case Kind::identifier:
        case Kind::fenced:
        case Kind::subscript:
            return true;
        case Kind::row:
            return layout.parts.size() == 3 && layout.parts[1].kind == Kind::apply;
        default:
            return false;
    }
}

std::string atom_text(const Layout& layout) {
    std::string text = text_of(layout);
    return is_atom(layout) ? text : "(" + std::move(text) + ")";
}

std::string script_text(const Layout& layout) {
    const std::string base = text_of(layout.parts[0]);
    const Layout& script = layout.parts[1];
    const bool raises = layout.kind == Kind::superscript;
    if (script.kind == Kind::fenced && script.text == "⟨⟩")
        return base + "^<" + text_of(script.parts[0]) + ">";
    const std::string plain = text_of(script);
    const std::string small = raises ? raised(plain) : lowered(plain);
    if (!small.empty()) return base + small;
    return base + (raises ? "^" : "_") + atom_text(script);
}

/// Whether a number and what follows it are read as a product without a space: 2t, 2(t + 1), (t + 1)(t + 2).
bool joins(std::string_view left, const Layout& before, const Layout& after) {
    const bool closes = left.ends_with(')');
    const Kind kind = after.kind;
    const bool name = kind == Kind::identifier || kind == Kind::subscript || kind == Kind::superscript;
    return (before.kind == Kind::number && (name || kind == Kind::fenced)) ||
           (closes && kind == Kind::fenced);
}

std::string row_text(const std::vector<Layout>& parts) {
    std::string text;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Layout& part = parts[i];
        switch (part.kind) {
            case Kind::relation:
                text += (text.empty() ? "" : " ") + part.text + " ";
                break;
            case Kind::binary:
                if (part.text == "·") {
                    text += part.text;
                } else {
                    text += (text.empty() ? "" : " ") + part.text + " ";
                }
                break;
            case Kind::comma:
                text += part.text + " ";
                break;
            case Kind::apply:
                break;
            case Kind::times:
                if (!joins(text, parts[i - 1], parts[i + 1])) text += " ";
                break;
            default:
                text += text_of(part);
        }
    }
    return text;
}

std::string fenced_text(const Layout& layout) {
    constexpr std::string_view angles = "⟨⟩";
    if (layout.text == angles) return "<" + text_of(layout.parts[0]) + ">";
    return layout.text.substr(0, 1) + text_of(layout.parts[0]) + layout.text.substr(1);
}

}  // namespace

std::string text_of(const Layout& layout) {
    switch (layout.kind) {
        case Kind::identifier:
            return letter(layout.text).unicode;
        case Kind::number:
        case Kind::words:
        case Kind::sign:
            return layout.text;
        case Kind::fraction:
            return atom_text(layout.parts[0]) + "/" + atom_text(layout.parts[1]);
        case Kind::superscript:
        case Kind::subscript:
            return script_text(layout);
        case Kind::fenced:
            return fenced_text(layout);
        case Kind::under:
            return text_of(layout.parts[0]) + "[" + text_of(layout.parts[1]) +
                   (layout.parts.size() == 3 ? ".." + text_of(layout.parts[2]) : "") + "] ";
        case Kind::cases:
            return "{" + text_of(layout.parts[0]) + " if " + text_of(layout.parts[1]) + ", " +
                   text_of(layout.parts[2]) + " otherwise}";
        case Kind::stack:
            return "C(" + text_of(layout.parts[0]) + ", " + text_of(layout.parts[1]) + ")";
        case Kind::row:
            return row_text(layout.parts);
        default:
            return row_text({layout});
    }
}

std::string to_text(const Formula& formula, const Notation& notation) {
    return text_of(layout_of(formula, notation));
}

}  // namespace blossom::worked
