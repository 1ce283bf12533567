#include "letters.hpp"

#include <blossom/rational/number_text.hpp>
#include <blossom/rational/utf8.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace blossom::worked {

namespace {

using Entry = std::pair<std::string_view, std::string_view>;

template <std::size_t n>
std::string_view looked_up(const std::array<Entry, n>& table, std::string_view key) {
    const auto entry = std::ranges::find(table, key, &Entry::first);
    return entry == table.end() ? std::string_view() : entry->second;
}

/// What LaTeX has commands for.
constexpr std::array<Entry, 34> greek{
    {{"alpha", "α"},   {"beta", "β"},  {"gamma", "γ"},  {"delta", "δ"}, {"epsilon", "ε"}, {"zeta", "ζ"},
     {"eta", "η"},     {"theta", "θ"}, {"iota", "ι"},   {"kappa", "κ"}, {"lambda", "λ"},  {"mu", "μ"},
     {"nu", "ν"},      {"xi", "ξ"},    {"pi", "π"},     {"rho", "ρ"},   {"sigma", "σ"},   {"tau", "τ"},
     {"upsilon", "υ"}, {"phi", "φ"},   {"chi", "χ"},    {"psi", "ψ"},   {"omega", "ω"},   {"Gamma", "Γ"},
     {"Delta", "Δ"},   {"Theta", "Θ"}, {"Lambda", "Λ"}, {"Xi", "Ξ"},    {"Pi", "Π"},      {"Sigma", "Σ"},
     {"Phi", "Φ"},     {"Psi", "Ψ"},   {"Omega", "Ω"},  {"det", "det"}}};

constexpr std::array<Entry, 21> signs{{{"−", "-"},          {"·", "\\cdot"},    {"∑", "\\sum"},
                                       {"∏", "\\prod"},     {"∂", "\\partial"}, {"∖", "\\setminus"},
                                       {"≥", "\\ge"},       {"∉", "\\notin"},   {"↦", "\\mapsto"},
                                       {"≤", "\\le"},       {"≠", "\\ne"},      {"≟", "\\overset{?}{=}"},
                                       {"⊆", "\\subseteq"}, {"∈", "\\in"},      {"→", "\\to"},
                                       {"′", "'"},          {"″", "''"},        {"‴", "'''"},
                                       {"…", "\\dots"},     {"≈", "\\approx"},  {"×", "\\times"}}};

/// What text, not formulas, may contain beyond ASCII.
constexpr std::array<Entry, 14> text_signs{{{"−", "$-$"},
                                            {"·", "$\\cdot$"},
                                            {"δ", "$\\delta$"},
                                            {"…", "\\dots{}"},
                                            {"≤", "$\\le$"},
                                            {"≠", "$\\ne$"},
                                            {"→", "$\\to$"},
                                            {"×", "$\\times$"},
                                            {"–", "--"},
                                            {"—", "---"},
                                            {"’", "'"},
                                            {"“", "``"},
                                            {"”", "''"},
                                            {"²", "$^2$"}}};

std::string escaped_for_latex(char c) {
    switch (c) {
        case '\\':
            return "\\textbackslash{}";
        case '~':
            return "\\textasciitilde{}";
        case '^':
            return "\\textasciicircum{}";
        case '<':
            return "\\textless{}";
        case '>':
            return "\\textgreater{}";
        case '|':
            return "\\textbar{}";
        case '"':
            return "\\textquotedbl{}";
        case '#':
        case '$':
        case '%':
        case '&':
        case '_':
        case '{':
        case '}':
            return std::string("\\") + c;
        default:
            return {c};
    }
}

}  // namespace

Letter letter(std::string_view name) {
    const std::string_view sign = looked_up(greek, name);
    if (!sign.empty()) return {std::string(sign), "\\" + std::string(name)};
    const std::string_view known = looked_up(signs, name);
    if (!known.empty()) return {std::string(name), std::string(known)};
    if (name.size() == 1) return {std::string(name), latex_text(name)};
    return {std::string(name), "\\mathit{" + latex_text(name) + "}"};
}

std::string latex_text(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::string_view character = first_character(text);
        const std::string_view known = looked_up(text_signs, character);
        if (!known.empty()) {
            result += known;
        } else if (character.size() == 1) {
            result += escaped_for_latex(character.front());
        } else {
            result += character;
        }
        text.remove_prefix(character.size());
    }
    return result;
}

std::size_t columns(std::string_view text) { return count_characters(text); }

std::string latex_sign(std::string_view sign) {
    const std::string_view known = looked_up(signs, sign);
    return std::string(known.empty() ? sign : known);
}

std::string padded(std::string text, std::size_t width) {
    const std::size_t present = columns(text);
    if (present < width) text.append(width - present, ' ');
    return text;
}

std::string wrapped(const std::vector<std::string>& pieces, std::size_t width, std::size_t indent) {
    std::string lines;
    std::size_t used = 0;
    for (const std::string& piece : pieces) {
        const std::size_t needed = columns(piece);
        if (!lines.empty() && used + 1 + needed > width) {
            lines += "\n" + std::string(indent, ' ');
            used = indent;
        } else if (!lines.empty()) {
            lines += " ";
            ++used;
        }
        lines += piece;
        used += needed;
    }
    return lines;
}

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent) {
    std::vector<std::string> pieces;
    while (!text.empty()) {
        const std::size_t length = std::min(text.find(' '), text.size());
        if (length > 0) pieces.emplace_back(text.substr(0, length));
        text.remove_prefix(std::min(length + 1, text.size()));
    }
    return wrapped(pieces, width, indent);
}

std::size_t widest_line(std::string_view text) {
    std::size_t widest = 0;
    while (!text.empty()) {
        const std::size_t length = std::min(text.find('\n'), text.size());
        widest = std::max(widest, columns(text.substr(0, length)));
        text.remove_prefix(std::min(length + 1, text.size()));
    }
    return widest;
}

std::string text_table(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()), 0);
        for (std::size_t j = 0; j < row.size(); ++j) widths[j] = std::max(widths[j], columns(row[j]));
    }
    std::string text;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::string line;
        for (std::size_t j = 0; j < rows[i].size(); ++j) line += padded(rows[i][j], widths[j] + 2);
        line.erase(line.find_last_not_of(' ') + 1);
        text += "  " + line + "\n";
        if (i > 0) continue;
        line.clear();
        for (const std::size_t width : widths) line += std::string(width, '-') + "  ";
        text += "  " + line.substr(0, line.size() - 2) + "\n";
    }
    return text;
}

}  // namespace blossom::worked
