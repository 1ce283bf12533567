#pragma once

#include <blossom/proofs/syntax.hpp>
#include <blossom/rational/limits.hpp>

#include <string>
#include <string_view>
#include <vector>

#include "lexer.hpp"

namespace blossom::proofs {

/// Reads expressions from tokens by recursive descent. Each function advances past what it read. Errors:
/// `syntax` at the token that does not fit; `limit_exceeded` for nesting.
class ExpressionParser {
public:
    ExpressionParser(const std::vector<Token>& tokens, const Limits& limits)
        : tokens_(tokens), limits_(limits) {}

    const Token& next() const { return tokens_[at_]; }
    const Token& peek(std::size_t ahead) const;
    void skip() {
        if (at_ + 1 < tokens_.size()) ++at_;
    }
    bool is(std::string_view symbol) const;
    bool is_word(std::string_view word) const;
    bool take(std::string_view symbol);
    bool take_word(std::string_view word);
    void expect(std::string_view symbol, std::string_view where);
    void expect_word(std::string_view word, std::string_view where);
    std::string identifier(std::string_view what);
    /// Throws the error that `what` was expected but something else was found.
    [[noreturn]] void refuse(std::string_view what) const;

    Expression expression();
    /// Expressions separated by commas.
    std::vector<Expression> expressions();
    /// t, t_1 or t_1..t_n.
    Expression name_or_run(std::string_view what);
    Range range();

private:
    Expression sum();
    Expression product();
    Expression signed_factor();
    Expression power();
    Expression primary();
    Expression named();
    Expression indices(Expression name);
    Expression parenthesis(std::size_t offset);
    Expression comparison();
    Expression call(Expression name);
    Expression derivative(std::size_t offset);
    Expression value(Expression map, std::vector<Expression> orders);
    Expression blossom_of(Expression map);
    Expression argument();
    Expression family(Expression member);
    std::vector<Expression> list(std::string_view close);

    const std::vector<Token>& tokens_;
    const Limits& limits_;
    std::size_t at_ = 0;
    std::size_t depth_ = 0;
};

}  // namespace blossom::proofs
