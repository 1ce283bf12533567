#include "lexer.hpp"

#include <blossom/rational/number_text.hpp>
#include <blossom/rational/utf8.hpp>
#include <blossom/rational/written_marks.hpp>

#include <algorithm>
#include <string>

namespace blossom::proofs {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool is_id_character(char c) { return is_letter(c) || is_digit(c) || c == '-' || c == '_' || c == '.'; }

/// Tokens after which a statement continues in the next line.
constexpr std::string_view unfinished[] = {"+", "-", "*", "/", "^", "==", "!=", "=", ",", ":", ";", ".."};
constexpr std::string_view two_characters[] = {"==", "!=", "..", "<=", ">="};

class Lexer {
public:
    explicit Lexer(std::string_view text) : text_(text) {}

    Tokens run() {
        while (at_ < text_.size()) step();
        end_line();
        add(TokenKind::end, text_.size(), 0);
        return std::move(result_);
    }

private:
    void step() {
        const char c = text_[at_];
        if (c == '\n') {
            ++at_;
            if (depth_ == 0 && !wants_more()) end_line();
            fresh_line_ = true;
        } else if (is_blank(c)) {
            ++at_;
        } else if (c == '#') {
            comment();
        } else if (is_letter(c)) {
            identifier();
        } else if (begins_number()) {
            number();
        } else if (superscript(rest()).length > 0) {
            exponent();
        } else if (c == '"') {
            string();
        } else {
            symbol();
        }
    }

    std::size_t length_while(bool (*belongs)(char)) const {
        std::size_t end = at_;
        while (end < text_.size() && belongs(text_[end])) ++end;
        return end - at_;
    }

    void comment() {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        std::string_view words = text_.substr(at_, end - at_);
        while (is_blank(words.back())) words.remove_suffix(1);
        result_.comments.push_back({at_, fresh_line_, std::string(words)});
        at_ = end;
    }

    void identifier() {
        const std::size_t length = length_while([](char c) { return is_letter(c) || is_digit(c); });
        const bool head = fresh_line_ && text_.substr(at_, length) == "theorem";
        if (head) {
            depth_ = 0;
            end_line();
        }
        add(TokenKind::identifier, at_, length);
        if (!head) return;
        at_ += length_while(is_blank);
        if (const std::size_t id = length_while(is_id_character)) add(TokenKind::identifier, at_, id);
    }

    std::string_view rest() const { return text_.substr(at_); }

    bool begins_number() const {
        const char c = text_[at_];
        if (is_digit(c)) return true;
        const bool may_begin = c == '.' || vulgar_fraction(rest()).length > 0;
        return may_begin && unsigned_number_length(rest()) > 0;
    }

    void number() {
        std::size_t length = length_while(is_digit);
        // "1..8" is a range, "1.5" a number.
        const std::string_view behind = rest().substr(length);
        const bool has_point = behind.starts_with('.') && !behind.starts_with("..");
        if (has_point || vulgar_fraction(behind).length > 0) length = unsigned_number_length(rest());
        add(TokenKind::number, at_, length);
    }

    /// "x²" is read as "x^2".
    void exponent() {
        const Superscript raised = superscript(rest());
        const std::string& digits = result_.exponents.emplace_back(raised.digits);
        const std::size_t begin = at_;
        add(TokenKind::symbol, begin, 0, "^");
        const bool negative = digits.starts_with('-');
        if (negative) add(TokenKind::symbol, begin, 0, "-");
        add(TokenKind::number, begin, raised.length, std::string_view(digits).substr(negative ? 1 : 0));
    }

    void string() {
        const std::size_t end = text_.find_first_of("\"\n", at_ + 1);
        if (end == std::string_view::npos || text_[end] == '\n') {
            add(TokenKind::invalid, at_, 1);
        } else {
            add(TokenKind::string, at_, end + 1 - at_);
        }
    }

    void symbol() {
        const std::string_view pair = text_.substr(at_, 2);
        if (std::ranges::find(two_characters, pair) != std::end(two_characters)) {
            add(TokenKind::symbol, at_, 2);
            return;
        }
        const WrittenMark mark = written_mark(rest());
        if (mark.length > 1) {
            constexpr std::string_view meanings = "-*/^";
            add(TokenKind::symbol, at_, mark.length, meanings.substr(meanings.find(mark.meaning), 1));
            return;
        }
        const char c = text_[at_];
        if (c == '(' || c == '[' || c == '{') ++depth_;
        if ((c == ')' || c == ']' || c == '}') && depth_ > 0) --depth_;
        const bool known = std::string_view("+-*/^()[]{}<>,;:=_'").find(c) != std::string_view::npos;
        std::size_t length = 1;
        while (!known && at_ + length < text_.size() && continues_character(text_[at_ + length])) ++length;
        add(known ? TokenKind::symbol : TokenKind::invalid, at_, length);
    }

    bool wants_more() const {
        return !result_.tokens.empty() && result_.tokens.back().kind == TokenKind::symbol &&
               std::ranges::find(unfinished, result_.tokens.back().text) != std::end(unfinished);
    }

    void end_line() {
        if (!result_.tokens.empty() && result_.tokens.back().kind != TokenKind::line_end) {
            const Token& last = result_.tokens.back();
            result_.tokens.push_back({TokenKind::line_end, last.offset + last.text.size(), {}, false});
        }
    }

    void add(TokenKind kind, std::size_t offset, std::size_t length) {
        add(kind, offset, length, text_.substr(offset, length));
    }
    /// A token that is read as if `meaning` stood there.
    void add(TokenKind kind, std::size_t offset, std::size_t length, std::string_view meaning) {
        result_.tokens.push_back({kind, offset, meaning, fresh_line_});
        fresh_line_ = false;
        at_ = offset + length;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t depth_ = 0;
    bool fresh_line_ = true;
    Tokens result_;
};

}  // namespace

Tokens tokenise(std::string_view text) { return Lexer(text).run(); }

}  // namespace blossom::proofs
