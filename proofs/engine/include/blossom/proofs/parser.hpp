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

/// What was read: blocks in order, comments, and one error for each block that could not be read. A block
/// with an error is left out; the others are not touched by it.
struct Document {
    std::optional<std::size_t> strict;  ///< where the line `strict` stands: every name must be declared
    std::vector<Block> blocks;
    std::vector<Comment> comments;
    std::vector<Error> errors;
};

/// Reads a text of the identity language. Every error has the offset of its place and says what was expected
/// there. Cost: linear in the text. Errors in the result: `syntax`; `limit_exceeded` for nesting.
Document parse(std::string_view text, const Limits& limits = {});

/// Errors: `syntax` unless some block has a line `claim` or `refute`.
void require_claim(const Document& document);

/// Line and column of an offset, both from 1; columns count characters of UTF-8.
struct LineAndColumn {
    std::size_t line;
    std::size_t column;
};
LineAndColumn line_and_column(std::string_view text, std::size_t offset);

/// "file:3:7: message", the line, and a caret below the place.
std::string diagnostic(std::string_view file, std::string_view text, const Error& error);

}  // namespace blossom::proofs
