#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

#include "expression_parser.hpp"

namespace blossom::proofs {

namespace {

std::string described(const Token& token) {
    switch (token.kind) {
        case TokenKind::end:
            return "the end of the text";
        case TokenKind::line_end:
            return "the end of the line";
        case TokenKind::invalid:
            return token.text == "\"" ? "a string that is not closed" : "the character " + quoted(token.text);
        default:
            return quoted(token.text);
    }
}

}  // namespace

const Token& ExpressionParser::peek(std::size_t ahead) const {
    return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
}

bool ExpressionParser::is(std::string_view symbol) const {
    return next().kind == TokenKind::symbol && next().text == symbol;
}

bool ExpressionParser::is_word(std::string_view word) const {
    return next().kind == TokenKind::identifier && next().text == word;
}

bool ExpressionParser::take(std::string_view symbol) {
    const bool found = is(symbol);
    if (found) skip();
    return found;
}

bool ExpressionParser::take_word(std::string_view word) {
    const bool found = is_word(word);
    if (found) skip();
    return found;
}

void ExpressionParser::refuse(std::string_view what) const {
    throw Error(ErrorCode::syntax, described(next()) + " found, expected " + std::string(what), {},
                next().offset);
}

void ExpressionParser::expect(std::string_view symbol, std::string_view where) {
    if (!take(symbol)) refuse("\"" + std::string(symbol) + "\" " + std::string(where));
}

void ExpressionParser::expect_word(std::string_view word, std::string_view where) {
    if (!take_word(word)) refuse("\"" + std::string(word) + "\" " + std::string(where));
}

std::string ExpressionParser::identifier(std::string_view what) {
    if (next().kind != TokenKind::identifier) refuse(what);
    std::string name(next().text);
    skip();
    return name;
}

}  // namespace blossom::proofs
