#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace blossom::worked {

/// A name as it is written.
struct Letter {
    std::string unicode;
    std::string latex;
};

/// "delta" as the Greek letter, "t" and signs such as "…" as themselves, a longer name as one word.
Letter letter(std::string_view name);

/// `text` with the characters that mean something to LaTeX escaped.
std::string latex_text(std::string_view text);

/// The number of columns that UTF-8 text takes in a terminal.
std::size_t columns(std::string_view text);

/// A sign such as "≤" or "↦" as LaTeX's mathematical mode writes it.
std::string latex_sign(std::string_view sign);

/// Words in lines of at most `width` columns, each after the first behind `indent` spaces.
std::string wrapped(std::string_view text, std::size_t width, std::size_t indent = 0);

/// Pieces in lines of at most `width` columns: a new line where the next piece would not fit.
std::string wrapped(const std::vector<std::string>& pieces, std::size_t width, std::size_t indent);

/// `text` with spaces behind it, at least `width` columns.
std::string padded(std::string text, std::size_t width);

/// The columns of the longest line.
std::size_t widest_line(std::string_view text);

/// The lines of a table with its header, columns set apart by two spaces.
std::string text_table(const std::vector<std::vector<std::string>>& rows);

}  // namespace blossom::worked
