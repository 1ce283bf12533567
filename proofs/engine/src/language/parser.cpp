#include <blossom/proofs/parser.hpp>
#include <blossom/rational/number_text.hpp>
#include <blossom/rational/utf8.hpp>

#include <algorithm>
#include <optional>

#include "expression_parser.hpp"
#include "statement_words.hpp"

namespace blossom::proofs {

namespace {

class Parser {
public:
    Parser(const std::vector<Token>& tokens, const Limits& limits) : reader_(tokens, limits) {}

    void run(Document& document, std::string_view text) {
        skip_empty_lines();
        if (reader_.is_word("strict") && reader_.peek(1).kind != TokenKind::symbol) {
            document.strict = reader_.next().offset;
            reader_.skip();
            skip_empty_lines();
        }
        while (reader_.next().kind != TokenKind::end) {
            try {
                Block read = block();
                read.strict = document.strict.has_value();
                read.text = text.substr(read.offset, reader_.next().offset - read.offset);
                document.blocks.push_back(std::move(read));
            } catch (const Error& error) {
                document.errors.push_back(error);
                skip_to_next_head();
            }
        }
    }

private:
    bool at_head() const { return reader_.next().first_of_line && reader_.is_word("theorem"); }

    void skip_empty_lines() {
        while (reader_.next().kind == TokenKind::line_end) reader_.skip();
    }

    void skip_to_next_head() {
        while (reader_.next().kind != TokenKind::end && !at_head()) reader_.skip();
    }

    void end_line() {
        if (reader_.next().kind == TokenKind::end) return;
        if (reader_.next().kind != TokenKind::line_end) reader_.refuse("an operator or the end of the line");
        skip_empty_lines();
    }

    Block block() {
        Block result;
        result.offset = reader_.next().offset;
        if (at_head()) head(result);
        while (reader_.next().kind != TokenKind::end && !at_head()) {
            result.statements.push_back(statement());
            end_line();
        }
        return result;
    }

    void head(Block& block) {
        reader_.skip();
        block.has_head = true;
        block.id = reader_.identifier("the id of the theorem");
        if (reader_.next().kind == TokenKind::string) {
            const std::string_view title = reader_.next().text;
            block.title = title.substr(1, title.size() - 2);
            reader_.skip();
        }
        end_line();
    }

    Statement statement() {
        const auto word = reader_.next().kind == TokenKind::identifier && reader_.next().first_of_line
                              ? find_statement(reader_.next().text)
                              : std::nullopt;
        if (!word) {
            reader_.refuse(
                "a line that begins with theorem, for, map, point, vector, frame, number, poly, raise, let, "
                "assume, given, claim or refute");
        }
        Statement result;
        result.kind = *word;
        result.offset = reader_.next().offset;
        reader_.skip();
        switch (*word) {
            case StatementKind::parameter:
                result.ranges.push_back(reader_.range());
                break;
            case StatementKind::map:
                map(result);
                break;
            case StatementKind::point:
            case StatementKind::vector:
            case StatementKind::frame:
                points(result);
                break;
            case StatementKind::number:
                names(result);
                break;
            case StatementKind::polynomial:
                polynomial(result);
                break;
            case StatementKind::raise:
                raise(result);
                break;
            case StatementKind::let:
                result.sides.push_back(reader_.name_or_run("the name to define"));
                reader_.expect("=", "after the name");
                result.sides.push_back(reader_.expression());
                break;
            default:
                if (*word == StatementKind::refute) result.some = takes_some();
                relation(result);
        }
        return result;
    }

    /// Reads `some` before an expression; but an expression may begin with a name `some`.
    bool takes_some() {
        const Token& after = reader_.peek(1);
        const bool begins =
            after.kind == TokenKind::identifier || after.kind == TokenKind::number || after.text == "<" ||
            after.text == "-" ||
            (after.text == "(" && after.offset > reader_.next().offset + reader_.next().text.size());
        return begins && reader_.take_word("some");
    }

    void degrees(Statement& result) {
        if (!reader_.take_word("degrees")) reader_.expect_word("degree", "or \"degrees\"");
        do result.expressions.push_back(reader_.expression());
        while (reader_.take(","));
    }

    void map(Statement& result) {
        do result.names.push_back(reader_.identifier("the name of a map"));
        while (reader_.take(","));
        degrees(result);
        if (reader_.take_word("on")) {
            reader_.expect_word("simplex", "after \"on\"");
            result.dimension.push_back(reader_.expression());
        }
        if (!reader_.take_word("net")) return;
        result.net = reader_.identifier("the name of the control points");
        reader_.expect_word("over", "before the points of the frame");
        result.frame = reader_.expressions();
    }

    void names(Statement& result) {
        do result.expressions.push_back(reader_.name_or_run("a name"));
        while (reader_.take(","));
    }

    void points(Statement& result) {
        names(result);
        reader_.expect_word("in", "before the dimension");
        result.dimension.push_back(reader_.expression());
    }

    void polynomial(Statement& result) {
        result.names.push_back(reader_.identifier("the name of the polynomial"));
        reader_.expect("(", "before the variables");
        do result.names.push_back(reader_.identifier("a variable"));
        while (reader_.take(","));
        reader_.expect(")", "after the variables");
        degrees(result);
        reader_.expect("=", "before the polynomial");
        result.sides.push_back(reader_.expression());
    }

    void raise(Statement& result) {
        result.names.push_back(reader_.identifier("the name of a map"));
        reader_.expect_word("to", "before the new degree");
        result.expressions = reader_.expressions();
        reader_.expect_word("as", "before the new name");
        result.names.push_back(reader_.identifier("the new name"));
    }

    void relation(Statement& result) {
        const bool differs = result.kind == StatementKind::assume;
        result.sides.push_back(reader_.expression());
        reader_.expect(differs ? "!=" : "==", "between the two sides");
        result.sides.push_back(reader_.expression());
        while (reader_.take_word("for")) {
            if (!reader_.is_word("all")) {
                result.ranges.push_back(reader_.range());
                continue;
            }
            if (result.kind != StatementKind::given)
                reader_.refuse("a range: \"for all\" belongs to hypotheses");
            reader_.skip();
            do result.quantified.push_back(reader_.name_or_run("a variable"));
            while (reader_.take(","));
        }
    }

    ExpressionParser reader_;
};

}  // namespace

Document parse(std::string_view text, const Limits& limits) {
    Document document;
    Tokens tokens = tokenise(text);
    document.comments = std::move(tokens.comments);
    Parser(tokens.tokens, limits).run(document, text);
    return document;
}

void require_claim(const Document& document) {
    const auto decides = [](const Statement& statement) {
        return statement.kind == StatementKind::claim || statement.kind == StatementKind::refute;
    };
    if (std::ranges::any_of(document.blocks, [&](const Block& block) {
            return std::ranges::any_of(block.statements, decides);
        }))
        return;
    throw Error(ErrorCode::syntax, R"(there is nothing to decide: no line begins with "claim" or "refute")");
}

LineAndColumn line_and_column(std::string_view text, std::size_t offset) {
    offset = std::min(offset, text.size());
    const std::size_t start = offset == 0 ? 0 : text.rfind('\n', offset - 1) + 1;
    const auto lines = static_cast<std::size_t>(std::ranges::count(text.substr(0, offset), '\n'));
    return {lines + 1, count_characters(text.substr(start, offset - start)) + 1};
}

std::string diagnostic(std::string_view file, std::string_view text, const Error& error) {
    if (!error.offset()) return std::string(file) + ": " + error.message() + "\n";
    constexpr std::size_t line_width = 100;
    const std::size_t offset = std::min(*error.offset(), text.size());
    const LineAndColumn place = line_and_column(text, offset);
    std::size_t first = offset == 0 ? 0 : text.rfind('\n', offset - 1) + 1;
    if (offset - first > line_width / 2) first = offset - line_width / 2;
    while (first < offset && continues_character(text[first])) ++first;
    std::size_t last = std::min({text.find('\n', offset), text.size(), first + line_width});
    while (last > offset && last < text.size() && continues_character(text[last])) --last;
    std::string line(text.substr(first, last - first));
    std::ranges::replace_if(line, [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    return std::string(file) + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + ": " +
           error.message() + "\n  " + line + "\n  " +
           std::string(count_characters(text.substr(first, offset - first)), ' ') + "^\n";
}

}  // namespace blossom::proofs
