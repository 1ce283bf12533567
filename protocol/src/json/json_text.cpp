#include "json_text.hpp"

#include <blossom/rational/number_text.hpp>
#include <blossom/rational/utf8.hpp>
#include <blossom/worked/json_characters.hpp>

#include <algorithm>
#include <charconv>
#include <utility>

#include "text/characters.hpp"

namespace blossom::protocol {

namespace {

bool is_space(char c) { return c <= ' ' && (c == ' ' || c == '\t' || c == '\n' || c == '\r'); }

void append_utf8(std::string& text, std::uint32_t code) {
    const auto byte = [&](std::uint32_t value) { text += static_cast<char>(value); };
    const auto continuation = [&](std::uint32_t shift) { byte(0x80 | (code >> shift & 0x3F)); };
    if (code < 0x80) return byte(code);
    if (code < 0x800) {
        byte(0xC0 | code >> 6);
    } else {
        if (code < 0x10000) {
            byte(0xE0 | code >> 12);
        } else {
            byte(0xF0 | code >> 18);
            continuation(12);
        }
        continuation(6);
    }
    continuation(0);
}

class Reader {
public:
    Reader(std::string_view text, const Limits& limits)
        : begin_(text.data()), at_(begin_), end_(begin_ + text.size()), limits_(limits) {
        constexpr std::size_t usual_depth = 4;
        open_.reserve(usual_depth);
    }

    JsonReading read() {
        try {
            take_word("\xEF\xBB\xBF");  // a byte order mark
            read_all();
        } catch (const Error& error) {
            // The outermost container is handed out with the members that were read whole.
            if (open_.size() > 1) remove_last(*open_.front());
            return {std::move(read_), error};
        }
        return {std::move(read_), std::nullopt};
    }

private:
    void read_all() {
        read_value(
            [this](auto&& value) -> Json& { return read_ = Json(std::forward<decltype(value)>(value)); });
        while (!open_.empty()) {
            Json& innermost = *open_.back();
            if (Json::Array* elements = innermost.array()) {
                read_elements(*elements);
            } else {
                read_members(*innermost.object());
            }
        }
        skip_spaces();
        if (at_ != end_) fail("the text goes on after its value");
    }

    /// Goes on with an array until it ends, or a container in it begins.
    void read_elements(Json::Array& elements) {
        const auto add = [&](auto&& value) -> Json& {
            return elements.emplace_back(std::forward<decltype(value)>(value));
        };
        do {
            if (ends(elements, ']', "expected ',' or ']' after an element")) return open_.pop_back();
        } while (!read_value(add));
    }

    /// Goes on with an object, likewise.
    void read_members(Json::Object& members) {
        std::string_view name;
        const auto add = [&](auto&& value) -> Json& {
            return members.emplace_back(name, std::forward<decltype(value)>(value)).second;
        };
        do {
            if (ends(members, '}', "expected ',' or '}' after a member")) {
                require_distinct_names(members);
                return open_.pop_back();
            }
            expect('"', "expected the name of a member in quotation marks");
            name = read_string(unescaped_name_);
            expect(':', "expected ':' after the name of a member");
        } while (!read_value(add));
    }

    /// Whether a container ends here; otherwise goes on to its next entry.
    bool ends(auto& container, char bracket, const char* rule) {
        if (!container.empty() && take(',')) return false;
        if (take(bracket)) return true;
        if (!container.empty()) fail(rule);
        constexpr std::size_t usual_size = 8;
        container.reserve(usual_size);
        return false;
    }

    /// Reads a value, and puts it where it belongs by `add`; of a container its beginning, and then the
    /// result is true. Containers that are open do not move: nothing is added to those around the innermost
    /// one.
    template <class Add>
    bool read_value(const Add& add) {
        skip_spaces();
        if (at_ == end_) fail("a value is missing");
        switch (*at_) {
            case '{':
                return open(Json::Object(), add);
            case '[':
                return open(Json::Array(), add);
            case '"':
                ++at_;
                add(read_string(unescaped_));
                return false;
            case 't':
                return read_word("true", true, add);
            case 'f':
                return read_word("false", false, add);
            case 'n':
                return read_word("null", Json(), add);
            default:
                add(Json::Number{std::string(read_number())});
                return false;
        }
    }

    bool open(auto container, const auto& add) {
        if (open_.size() >= limits_.nesting) {
            throw limit_error("brackets nested deeper than", "nesting", limits_.nesting);
        }
        open_.push_back(&add(std::move(container)));
        ++at_;
        return true;
    }

    static void remove_last(Json& container) {
        if (Json::Array* elements = container.array()) {
            elements->pop_back();
        } else {
            container.object()->pop_back();
        }
    }

    void require_distinct_names(const Json::Object& members) const {
        constexpr std::size_t few = 8;
        if (members.size() <= few) {
            for (std::size_t i = 1; i < members.size(); ++i) {
                for (std::size_t j = 0; j < i; ++j)
                    if (members[i].first == members[j].first) refuse_name(members[i].first);
            }
            return;
        }
        std::vector<std::string_view> names;
        for (const auto& [name, value] : members) names.push_back(name);
        std::ranges::sort(names);
        const auto repeated = std::ranges::adjacent_find(names);
        if (repeated != names.end()) refuse_name(*repeated);
    }

    [[noreturn]] void refuse_name(std::string_view name) const {
        Place place;
        for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
            const Json::Array* elements = open_[i]->array();
            place = elements ? place / (elements->size() - 1) : place / open_[i]->object()->back().first;
        }
        throw Error(ErrorCode::syntax, "the name " + to_text(Json(name)) + " occurs twice in one object",
                    place);
    }

    bool read_word(std::string_view word, auto value, const auto& add) {
        if (!take_word(word)) fail("expected a value");
        add(std::move(value));
        return false;
    }

    std::string_view read_number() {
        const char* const start = at_;
        if (peek() == '-') ++at_;
        if (!is_digit(peek())) fail(at_ == start ? "expected a value" : "expected a digit");
        if (peek() == '0') {
            ++at_;
            if (is_digit(peek())) fail("a number does not begin with 0 and another digit");
        } else {
            skip_digits();
        }
        if (peek() == '.') {
            ++at_;
            skip_digits();
        }
        if (peek() == 'e' || peek() == 'E') {
            ++at_;
            if (peek() == '+' || peek() == '-') ++at_;
            skip_digits();
        }
        return {start, at_};
    }

    void skip_digits() {
        if (!is_digit(peek())) fail("expected a digit");
        while (is_digit(peek())) ++at_;
    }

    /// Reads what follows a quotation mark up to the next one; `result` is for what has escapes.
    std::string_view read_string(std::string& result) {
        const char* start = at_;
        skip_plain();
        if (peek() == '"') return {start, at_++};
        result.clear();
        for (;;) {
            result.append(start, at_);
            if (at_ == end_) fail("the closing quotation mark is missing");
            start = at_;
            const char c = *at_;
            if (c == '"') break;
            if (c == '\\') {
                read_escape(result);
                start = at_;
            } else if (const std::size_t length = character_length(rest()); length > 1) {
                at_ += length;
            } else {
                fail(length == 1 ? "a control character in a string; write it as an escape"
                                 : "not a character of UTF-8");
            }
            skip_plain();
        }
        ++at_;
        return result;
    }

    void skip_plain() { at_ = std::find_if_not(at_, end_, is_plain_in_json); }

    void read_escape(std::string& result) {
        ++at_;
        constexpr std::string_view letters = "\"\\/bfnrt";
        constexpr std::string_view meanings = "\"\\/\b\f\n\r\t";
        const char letter = peek();
        if (const std::size_t i = letters.find(letter); at_ != end_ && i != std::string_view::npos) {
            ++at_;
            result += meanings[i];
            return;
        }
        if (letter != 'u') fail("a backslash in a string is followed by one of \"\\/bfnrtu");
        ++at_;
        std::uint32_t code = read_unit();
        if (code >= 0xDC00 && code <= 0xDFFF) fail("the second half of a character without the first");
        if (code >= 0xD800 && code <= 0xDBFF) {
            const std::uint32_t low = take_word("\\u") ? read_unit() : 0;
            if (low < 0xDC00 || low > 0xDFFF) fail("the first half of a character without the second");
            code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
        }
        append_utf8(result, code);
    }

    /// The four hexadecimal digits of a unit of UTF-16.
    std::uint32_t read_unit() {
        constexpr std::size_t digits = 4;
        const std::string_view written = rest().substr(0, digits);
        std::uint32_t unit = 0;
        const auto [end, problem] =
            std::from_chars(written.data(), written.data() + written.size(), unit, 16);
        const auto read = static_cast<std::size_t>(end - written.data());
        at_ += read;
        if (read < digits) fail("expected a hexadecimal digit");
        return unit;
    }

    std::string_view rest() const { return {at_, end_}; }

    /// The next byte; 0 at the end.
    char peek() const { return at_ != end_ ? *at_ : '\0'; }

    void skip_spaces() {
        while (at_ != end_ && is_space(*at_)) ++at_;
    }

    bool take(char c) {
        skip_spaces();
        if (peek() != c) return false;
        ++at_;
        return true;
    }

    bool take_word(std::string_view word) {
        if (!rest().starts_with(word)) return false;
        at_ += word.size();
        return true;
    }

    void expect(char c, const char* rule) {
        if (!take(c)) fail(rule);
    }

    [[noreturn]] void fail(std::string_view rule) const {
        const std::string found =
            at_ != end_ ? ", found " + quoted(first_character(rest())) : ", the text ends";
        const auto place = static_cast<std::size_t>(at_ - begin_);
        throw Error(ErrorCode::syntax, "byte " + std::to_string(place + 1) + ": " + std::string(rule) + found,
                    {}, place);
    }

    const char* begin_;
    const char* at_;
    const char* end_;
    const Limits& limits_;
    std::string unescaped_name_;  ///< the name that was read last, if it has escapes
    std::string unescaped_;       ///< likewise of other strings
    Json read_;                   ///< the value, once it has begun
    std::vector<Json*> open_;     ///< the containers around the place that is being read
};

}  // namespace

JsonReading read_json(std::string_view text, const Limits& limits) { return Reader(text, limits).read(); }

Json parse_json(std::string_view text, const Limits& limits) {
    JsonReading reading = read_json(text, limits);
    if (reading.error) throw Error(*reading.error);
    return std::move(reading.value);
}

}  // namespace blossom::protocol
