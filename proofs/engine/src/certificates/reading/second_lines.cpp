#include "second_parser.hpp"

#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <tuple>
#include <utility>

namespace blossom::proofs::second {

Parser::Parser(std::string_view block_text, Reading& reading)
    : reading_(reading), text_(tokens_of_block(block_text)) {
    reading_.strict_ = text_.strict;
}

const Token& Parser::after(std::size_t count) const {
    return text_.tokens[std::min(place_ + count, text_.tokens.size() - 1)];
}

bool Parser::is_mark(std::string_view mark) const {
    return next().kind == TokenKind::mark && next().text == mark;
}

bool Parser::is_word(std::string_view word) const {
    return next().kind == TokenKind::word && next().text == word;
}

bool Parser::take_mark(std::string_view mark) {
    if (!is_mark(mark)) return false;
    ++place_;
    return true;
}

bool Parser::take_word(std::string_view word) {
    if (!is_word(word)) return false;
    ++place_;
    return true;
}

void Parser::expect_mark(std::string_view mark) {
    if (!take_mark(mark)) fail("\"" + std::string(mark) + "\"");
}

void Parser::expect_word(std::string_view word) {
    if (!take_word(word)) fail("\"" + std::string(word) + "\"");
}

std::uint32_t Parser::expect_name() {
    if (next().kind != TokenKind::word) fail("a name");
    const std::uint32_t name = intern(next().text);
    ++place_;
    return name;
}

void Parser::fail(const std::string& expected) const {
    const bool ends = next().kind == TokenKind::line_end || next().kind == TokenKind::text_end;
    throw Error(
        ErrorCode::syntax,
        (ends ? std::string("the end of the line") : quoted(next().text)) + " found, expected " + expected,
        {}, next().offset);
}

std::uint32_t Parser::intern(std::string_view name) {
    const auto found = interned_.find(name);
    if (found != interned_.end()) return found->second;
    const auto text = static_cast<std::uint32_t>(reading_.names_.size());
    reading_.names_.emplace_back(name);
    interned_.emplace(std::string(name), text);
    return text;
}

NodeId Parser::add(Form form, std::size_t offset, std::vector<NodeId> children) {
    Node made;
    made.form = form;
    made.offset = offset;
    made.children = std::move(children);
    reading_.nodes_.push_back(std::move(made));
    return static_cast<NodeId>(reading_.nodes_.size() - 1);
}

void Parser::parse_block() {
    while (next().kind != TokenKind::text_end) {
        if (next().kind != TokenKind::line_end) {
            parse_line();
            if (next().kind != TokenKind::line_end) fail("the end of the line");
        }
        ++place_;
        ++line_;
    }
}

void Parser::parse_line() {
    const std::size_t offset = next().offset;
    if (take_word("for")) return parse_parameter();
    if (take_word("map")) return parse_map(offset);
    if (take_word("point")) return parse_declaration(Declaration::Kind::point, offset);
    if (take_word("vector")) return parse_declaration(Declaration::Kind::vector, offset);
    if (take_word("number")) return parse_declaration(Declaration::Kind::number, offset);
    if (take_word("frame")) return parse_frame(offset);
    if (take_word("poly")) return parse_polynomial(offset);
    if (take_word("raise")) return parse_raise(offset);
    if (take_word("let")) return parse_abbreviation(offset);
    if (take_word("assume")) return parse_statement(Statement::Kind::assume, offset);
    if (take_word("given")) return parse_statement(Statement::Kind::given, offset);
    if (take_word("claim")) return parse_statement(Statement::Kind::claim, offset);
    if (take_word("refute")) {
        // A claim may begin with a number named `some`.
        const bool of_some = is_word("some") && (after(1).kind != TokenKind::mark || after(1).text == "(" ||
                                                 after(1).text == "<" || after(1).text == "-");
        if (of_some) ++place_;
        return parse_statement(of_some ? Statement::Kind::refute_some : Statement::Kind::refute, offset);
    }
    fail("for, map, point, vector, number, frame, poly, raise, let, assume, given, claim or refute");
}

Range Parser::parse_range_of(std::uint32_t name) {
    expect_word("in");
    const NodeId low = parse_expression();
    expect_mark("..");
    return {name, low, parse_expression()};
}

void Parser::parse_statement(Statement::Kind kind, std::size_t offset) {
    Statement statement;
    statement.kind = kind;
    statement.offset = offset;
    statement.left = parse_expression();
    expect_mark(kind == Statement::Kind::assume ? "!=" : "==");
    statement.right = parse_expression();
    while (take_word("for")) {
        if (kind == Statement::Kind::given && take_word("all")) {
            parse_for_all(statement);
        } else {
            statement.ranges.push_back(parse_range_of(expect_name()));
            require_within(statement.ranges.size(), reading_.limits_.nesting, "nesting",
                           "the number of ranges");
        }
    }
    if (kind == Statement::Kind::given) {
        reading_.hypotheses_.push_back(std::move(statement));
    } else if (kind == Statement::Kind::assume) {
        reading_.assumptions_.push_back(std::move(statement));
    } else {
        reading_.claims_.push_back(std::move(statement));
    }
}

void Parser::parse_for_all(Statement& statement) {
    do {
        Quantified quantified;
        quantified.name = expect_name();
        if (is_mark("_")) {
            quantified.bare = false;
            std::tie(quantified.first, quantified.last) = parse_member_run(quantified.name);
        }
        statement.for_all.push_back(std::move(quantified));
    } while (take_mark(","));
}

}  // namespace blossom::proofs::second
