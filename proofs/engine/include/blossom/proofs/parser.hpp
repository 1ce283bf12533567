#pragma once

#include <blossom/proofs/syntax.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace blossom::proofs {

/// The result of parsing: blocks in order, comments, and one error for each block that could not be read.
/// Such a block is omitted and does not affect the others.
struct Document {
    /// the position of the line `strict`, after which every name must be declared
    std::optional<std::size_t> strict;
    std::vector<Block> blocks;
    std::vector<Comment> comments;
    std::vector<Error> errors;
};

/// Parses a text of the identity language. Every error has an offset and names what was expected there. Cost:
/// linear in the text. Errors in the result: `syntax`; `limit_exceeded` for nesting.
Document parse(std::string_view text, const Limits& limits = {});

/// Errors: `syntax` unless a block has a line `claim` or `refute`.
void require_claim(const Document& document);

/// Line and column of an offset, both from 1; a column is a number of UTF-8 characters.
struct LineAndColumn {
    std::size_t line;
    std::size_t column;
};
LineAndColumn line_and_column(std::string_view text, std::size_t offset);

/// "file:3:7: message", the line of the text, and a caret below the position.
std::string diagnostic(std::string_view file, std::string_view text, const Error& error);

}  // namespace blossom::proofs
