#include "text_width.hpp"

#include <algorithm>

#include "letters.hpp"

namespace blossom::worked {

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
