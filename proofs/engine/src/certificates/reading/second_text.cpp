#include "second_text.hpp"

#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <array>
#include <string>

namespace blossom::proofs::second {

namespace {

bool is_letter_of_word(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool is_digit_of_number(char c) { return c >= '0' && c <= '9'; }

/// Longer marks precede their own prefixes.
constexpr std::array<std::string_view, 25> marks = {"==", "!=", "<=", ">=", "..", "+", "-", "*", "/",
                                                    "^",  "=",  "<",  ">",  "(",  ")", "[", "]", "{",
                                                    "}",  ",",  ":",  ";",  "_",  "'", "."};

/// Other spellings of marks.
struct Spelling {
    std::string_view written;
    std::string_view mark;
};
constexpr std::array<Spelling, 7> spellings = {{{"**", "^"},
                                                {"\u2212", "-"},
                                                {"\u00B7", "*"},
                                                {"\u22C5", "*"},
                                                {"\u00D7", "*"},
                                                {"\u2044", "/"},
                                                {"\u2215", "/"}}};

/// The superscript digits from 0 to 9.
constexpr std::array<std::string_view, 10> small_digits = {"\u2070", "\u00B9", "\u00B2", "\u00B3", "\u2074",
                                                           "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
constexpr std::string_view small_minus = "\u207B";
constexpr std::string_view small_plus = "\u207A";

/// Whether a line goes on behind `mark`. A > at the end of a line closes a pair: comparisons stand within
/// brackets.
bool continues_line(std::string_view mark) {
    constexpr std::array<std::string_view, 16> open = {"+", "-", "*", "/",  "^", "==", "!=", "=",
                                                       ",", ":", ";", "..", "<", "<=", ">=", "."};
    return std::ranges::find(open, mark) != open.end();
}

class TokenCutter {
public:
    explicit TokenCutter(std::string_view text) : text_(text) {}

    BlockText cut() {
        bool at_line_begin = true;
        while (place_ < text_.size()) {
            if (at_line_begin && take_head()) continue;
            const char c = text_[place_];
            if (c == '\n') {
                end_line();
                at_line_begin = true;
            } else if (c == ' ' || c == '\t' || c == '\r') {
                ++place_;
            } else if (c == '#') {
                skip_line();
            } else {
                at_line_begin = false;
                take_token();
            }
        }
        depth_ = 0;
        if (!block_.tokens.empty() && block_.tokens.back().kind != TokenKind::line_end) {
            block_.tokens.push_back({TokenKind::line_end, text_.substr(place_, 0), place_});
        }
        block_.tokens.push_back({TokenKind::text_end, text_.substr(place_, 0), place_});
        return std::move(block_);
    }

private:
    std::string_view rest() const { return text_.substr(place_); }

    /// The word at the first character of this line that is not a space.
    std::string_view first_word() const {
        std::size_t begin = place_;
        while (begin < text_.size() && (text_[begin] == ' ' || text_[begin] == '\t')) ++begin;
        std::size_t end = begin;
        while (end < text_.size() && (is_letter_of_word(text_[end]) || is_digit_of_number(text_[end]))) ++end;
        return text_.substr(begin, end - begin);
    }

    bool take_head() {
        const std::string_view word = first_word();
        if (word == "theorem") {
            if (!block_.tokens.empty() || has_head_) {
                throw Error(ErrorCode::syntax, "a second theorem begins within one block", {}, place_);
            }
            has_head_ = true;
            skip_line();
            return true;
        }
        if (word == "strict" && block_.tokens.empty() && !has_head_ && !block_.strict) {
            block_.strict = true;
            place_ = static_cast<std::size_t>(word.data() - text_.data()) + word.size();
            while (place_ < text_.size() && text_[place_] != '\n') {
                if (text_[place_] == '#') {
                    skip_line();
                    break;
                }
                if (text_[place_] != ' ' && text_[place_] != '\t' && text_[place_] != '\r') {
                    throw Error(ErrorCode::syntax, "the line strict has nothing behind this word", {},
                                place_);
                }
                ++place_;
            }
            return true;
        }
        return false;
    }

    void skip_line() {
        while (place_ < text_.size() && text_[place_] != '\n') ++place_;
    }

    void end_line() {
        const bool goes_on =
            depth_ > 0 || block_.tokens.empty() || block_.tokens.back().kind == TokenKind::line_end ||
            (block_.tokens.back().kind == TokenKind::mark && continues_line(block_.tokens.back().text));
        if (!goes_on) block_.tokens.push_back({TokenKind::line_end, text_.substr(place_, 0), place_});
        ++place_;
    }

    void take_token() {
        if (is_letter_of_word(text_[place_])) {
            std::size_t length = 1;
            while (length < rest().size() &&
                   (is_letter_of_word(rest()[length]) || is_digit_of_number(rest()[length]))) {
                ++length;
            }
            push(TokenKind::word, length);
        } else if (is_digit_of_number(text_[place_])) {
            push(TokenKind::number, number_length());
        } else if (unsigned_number_length(rest()) > 0) {  // ".5" or a fraction that is one character
            push(TokenKind::number, unsigned_number_length(rest()));
        } else if (!take_superscript() && !take_spelling()) {
            take_mark();
        }
    }

    std::size_t number_length() const {
        if (!block_.tokens.empty() && block_.tokens.back().text == "_") {
            std::size_t length = 1;
            while (length < rest().size() && is_digit_of_number(rest()[length])) ++length;
            return length;
        }
        return unsigned_number_length(rest());
    }

    bool take_spelling() {
        for (const Spelling& spelling : spellings) {
            if (!rest().starts_with(spelling.written)) continue;
            block_.tokens.push_back({TokenKind::mark, spelling.mark, place_});
            place_ += spelling.written.size();
            return true;
        }
        return false;
    }

    /// Digits above the line are the exponent of what stands before them.
    bool take_superscript() {
        std::string_view above = rest();
        const bool below_zero = above.starts_with(small_minus);
        if (below_zero || above.starts_with(small_plus)) above.remove_prefix(small_minus.size());
        std::string digits;
        for (bool found = true; found;) {
            found = false;
            for (std::size_t d = 0; d < small_digits.size(); ++d) {
                if (!above.starts_with(small_digits[d])) continue;
                digits += static_cast<char>('0' + d);
                above.remove_prefix(small_digits[d].size());
                found = true;
                break;
            }
        }
        if (digits.empty()) return false;
        block_.tokens.push_back({TokenKind::mark, "^", place_});
        if (below_zero) block_.tokens.push_back({TokenKind::mark, "-", place_});
        block_.tokens.push_back({TokenKind::number, block_.raised.emplace_back(std::move(digits)), place_});
        place_ = text_.size() - above.size();
        return true;
    }

    void take_mark() {
        for (const std::string_view mark : marks) {
            if (!rest().starts_with(mark)) continue;
            if (mark == "(" || mark == "[" || mark == "{") ++depth_;
            if ((mark == ")" || mark == "]" || mark == "}") && depth_ > 0) --depth_;
            push(TokenKind::mark, mark.size());
            return;
        }
        throw Error(ErrorCode::syntax,
                    quoted(first_character(rest())) + " belongs to no word of the language", {}, place_);
    }

    void push(TokenKind kind, std::size_t length) {
        block_.tokens.push_back({kind, rest().substr(0, length), place_});
        place_ += length;
    }

    std::string_view text_;
    std::size_t place_ = 0;
    std::size_t depth_ = 0;
    bool has_head_ = false;
    BlockText block_;
};

}  // namespace

BlockText tokens_of_block(std::string_view block_text) { return TokenCutter(block_text).cut(); }

}  // namespace blossom::proofs::second
