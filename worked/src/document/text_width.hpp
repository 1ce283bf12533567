#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace blossom::worked {

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
