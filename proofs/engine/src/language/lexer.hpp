#pragma once

#include <blossom/proofs/syntax.hpp>

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace blossom::proofs {

enum class TokenKind { identifier, number, string, symbol, line_end, end, invalid };

struct Token {
    TokenKind kind;
    std::size_t offset;
    std::string_view text;
    bool first_of_line;
};

struct Tokens {
    std::vector<Token> tokens;  ///< the last one is the end
    std::vector<Comment> comments;
    std::deque<std::string> exponents;  ///< the texts of superscripts, in ASCII
};

/// The tokens of a text. A line ends if no bracket is open and the last token needs no continuation. A head
/// `theorem` at the beginning of a line closes all brackets, so that an unclosed bracket spoils only one
/// block.
Tokens tokenise(std::string_view text);

}  // namespace blossom::proofs
