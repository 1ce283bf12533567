#include "bracketed_lists.hpp"

#include <blossom/rational/error.hpp>
#include <blossom/rational/limits.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <charconv>
#include <string>
#include <utility>

#include "characters.hpp"

namespace blossom::protocol {

namespace {

bool is_separator(char c) { return std::string_view(" \t\r\n,;").find(c) != std::string_view::npos; }
bool ends_number(char c) {
    return is_separator(c) || std::string_view("[](){}'\"").find(c) != std::string_view::npos;
}

char closing(char open) { return open == '(' ? ')' : ']'; }

class Reader {
public:
    explicit Reader(std::string_view text) : text_(text) {}

    Json read() {
        Json::Array lists;
        for (skip_separators(); at_ < text_.size(); skip_separators()) lists.push_back(sum());
        return lists.size() == 1 && lists.front().array() ? std::move(lists.front()) : Json(std::move(lists));
    }

private:
    [[noreturn]] void fail(std::size_t place, const std::string& message) const {
        throw Error(ErrorCode::syntax, message, {}, place);
    }
    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    void skip_separators() {
        while (at_ < text_.size() && is_separator(text_[at_])) ++at_;
    }
    void skip_blanks() {
        while (at_ < text_.size() && is_separator(text_[at_]) && text_[at_] != ',' && text_[at_] != ';')
            ++at_;
    }
    bool accept(char c) {
        skip_blanks();
        if (peek() != c) return false;
        ++at_;
        return true;
    }
    std::string_view word() {
        const std::size_t begin = at_;
        while (is_letter(peek()) || is_digit(peek()) || peek() == '.') ++at_;
        return text_.substr(begin, at_ - begin);
    }
    std::string_view number() {
        const std::size_t begin = at_;
        while (at_ < text_.size() && !ends_number(text_[at_])) ++at_;
        return text_.substr(begin, at_ - begin);
    }

    /// "[0]*4 + [1]"; anything that is no list stands for itself.
    Json sum() {
        Json first = product();
        while (first.array() && accept('+')) {
            skip_blanks();
            const std::size_t begin = at_;
            const Json next = product();
            if (!next.array()) fail(begin, "a list is expected behind '+'");
            first.array()->insert(first.array()->end(), next.array()->begin(), next.array()->end());
        }
        return first;
    }

    Json product() {
        Json list = value();
        const bool of_numbers = list.array() && std::ranges::none_of(*list.array(), [](const Json& element) {
                                    return element.array();
                                });
        if (!of_numbers || !accept('*')) return list;
        skip_blanks();
        const std::size_t begin = at_;
        const auto count = repetitions(number());
        if (!count) fail(begin, "a count is expected behind '*'");
        const std::size_t total = list.array()->size() * *count;
        repeated_ += total;
        require_within(repeated_, Limits{}.numbers, "numbers", "the count of numbers");
        Json::Array repeated;
        repeated.reserve(total);
        for (std::size_t i = 0; i < *count; ++i)
            repeated.insert(repeated.end(), list.array()->begin(), list.array()->end());
        return repeated;
    }

    Json value() {
        const char c = peek();
        if (c == '[' || c == '(') return elements(c);
        if (c == '\'' || c == '"') return in_quotes(c);
        if (is_letter(c)) return named();
        const std::size_t begin = at_;
        const std::string_view read = number();
        if (read.empty())
            fail(begin,
                 "a number or a bracket is expected, found " + quoted(first_character(text_.substr(at_))));
        if (read == "...") fail(begin, "the list was shortened when it was printed; \"...\" is no number");
        return read;
    }

    Json in_quotes(char quote) {
        const std::size_t begin = at_;
        const std::size_t end = text_.find(quote, begin + 1);
        if (end == std::string_view::npos) fail(begin, "the closing quotation mark is missing");
        at_ = end + 1;
        return text_.substr(begin + 1, end - begin - 1);
    }

    Json elements(char open) {
        const std::size_t begin = at_++;
        const Limits limits;
        if (++depth_ > limits.nesting)
            throw limit_error("brackets nested deeper than", "nesting", limits.nesting);
        Json::Array list;
        for (skip_separators(); peek() != closing(open); skip_separators()) {
            if (at_ == text_.size())
                fail(begin, std::string("the bracket is not closed by '") + closing(open) + "'");
            if (Json element = sum(); !element.is_null()) list.push_back(std::move(element));
        }
        ++at_;
        --depth_;
        return list;
    }

    /// array(...), Fraction(1, 2) or another call; "dtype=float" says nothing.
    Json named() {
        const std::size_t begin = at_;
        const std::string_view name = word();
        if (accept('=')) {
            skip_blanks();
            if (peek() == '\'' || peek() == '"')
                in_quotes(peek());
            else
                number();
            return {};
        }
        if (peek() != '(') {
            at_ = begin;
            return number();
        }
        Json arguments = elements('(');
        Json::Array& list = *arguments.array();
        if (list.empty()) fail(begin, quoted(name) + " has no value");
        const bool quotient = list.size() == 2 && list[0].text() && list[1].text();
        if (quotient) return *list[0].text() + "/" + *list[1].text();
        return std::move(list.front());
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t depth_ = 0;
    std::size_t repeated_ = 0;  ///< the count of numbers that repetitions have made
};

}  // namespace

std::optional<std::size_t> repetitions(std::string_view text) {
    const std::size_t most = Limits{}.degree + 1;
    while (text.starts_with(' ')) text.remove_prefix(1);
    std::size_t count = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), count);
    const bool is_count = problem == std::errc{} && end == text.data() + text.size() && count <= most;
    return is_count ? std::optional(count) : std::nullopt;
}

bool is_bracketed(std::string_view text) {
    const std::size_t first = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    const std::string_view rest = text.substr(first);
    if (rest.starts_with('[') || rest.starts_with('(')) return true;
    const std::size_t name = static_cast<std::size_t>(
        std::ranges::find_if_not(rest, [](char c) { return is_letter(c) || is_digit(c) || c == '.'; }) -
        rest.begin());
    return name > 0 && is_letter(rest.front()) && rest.substr(name).starts_with('(');
}

Json bracketed_list(std::string_view text) { return Reader(text).read(); }

}  // namespace blossom::protocol
