#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace blossom::proofs::second {

enum class TokenKind : std::uint8_t { word, number, mark, line_end, text_end };

/// A token; `text` refers to the original text.
struct Token {
    TokenKind kind = TokenKind::text_end;
    std::string_view text;
    std::size_t offset = 0;
};

/// The lines of one block, cut into tokens.
struct BlockText {
    bool strict = false;
    std::vector<Token> tokens;       ///< the last is text_end, after a line_end
    std::deque<std::string> raised;  ///< the digits of superscripts
};

/// Splits a block into tokens, without its line `theorem` and without comments.
/// Errors: `syntax` for a character that begins no token and for a second line `theorem`.
BlockText tokens_of_block(std::string_view block_text);

}  // namespace blossom::proofs::second
