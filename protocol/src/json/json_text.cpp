#include "json_text.hpp"

#include <blossom/rational/number_text.hpp>
#include <blossom/rational/utf8.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace blossom::protocol {

namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Whether a character stands for itself in a string, and is one byte.
constexpr std::array<bool, 256> plain_bytes = [] {
    std::array<bool, 256> plain{};
    for (std::size_t byte = 0x20; byte < 0x80; ++byte) plain[byte] = byte != '"' && byte != '\\';
    return plain;
}();

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
    Reader(std::string_view text, const Limits& limits) : text_(text), limits_(limits) {
        constexpr std::size_t usual_depth = 4;
        open_.reserve(usual_depth);
    }

    JsonReading read() {
        try {
            if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;  // a byte order mark
            read_all();
        } catch (const Error& error) {
            // The outermost container is handed out with the members that were read whole.
            if (open_.size() > 1) remove_last(*open_.front());
            return {read_.empty() ? Json() : std::move(read_.front()), error};
        }
        return {std::move(read_.front()), std::nullopt};
    }

private:
    void read_all() {
        read_value();
        while (!open_.empty()) {
            if (open_.back()->array()) {
                read_next_element();
            } else {
                read_next_member();
            }
        }
        skip_spaces();
        if (at_ < text_.size()) fail("the text goes on after its value");
    }

    void read_next_element() {
        const bool first = open_.back()->array()->empty();
        if (take(']')) return close();
        if (!first) expect(',', "expected ',' or ']' after an element");
        read_value();
    }

    void read_next_member() {
        const bool first = open_.back()->object()->empty();
        if (take('}')) {
            require_distinct_names();
            return close();
        }
        if (!first) expect(',', "expected ',' or '}' after a member");
        skip_spaces();
        expect('"', "expected the name of a member in quotation marks");
        name_ = read_string();
        expect(':', "expected ':' after the name of a member");
        read_value();
    }

    /// Reads a value, of a container its beginning.
    void read_value() {
        skip_spaces();
        if (at_ == text_.size()) fail("a value is missing");
        switch (text_[at_]) {
            case '{':
                return open(Json::Object());
            case '[':
                return open(Json::Array());
            case '"':
                ++at_;
                add(read_string());
                return;
            case 't':
                return read_word("true", true);
            case 'f':
                return read_word("false", false);
            case 'n':
                return read_word("null", Json());
            default:
                add(Json::Number{read_number()});
        }
    }

    /// Puts a value where the next one belongs. Containers that are open do not move: nothing is added to
    /// those around the innermost one.
    template <class Value>
    Json& add(Value&& value) {
        if (open_.empty()) return read_.emplace_back(std::forward<Value>(value));
        if (Json::Array* elements = open_.back()->array())
            return elements->emplace_back(std::forward<Value>(value));
        return open_.back()->object()->emplace_back(std::move(name_), std::forward<Value>(value)).second;
    }

    template <class Container>
    void open(Container container) {
        if (open_.size() >= limits_.nesting) {
            throw Error(ErrorCode::limit_exceeded,
                        "brackets nested deeper than the limit nesting = " + std::to_string(limits_.nesting));
        }
        constexpr std::size_t usual_size = 4;
        container.reserve(usual_size);
        open_.push_back(&add(std::move(container)));
        ++at_;
    }

    void close() { open_.pop_back(); }

    static void remove_last(Json& container) {
        if (Json::Array* elements = container.array()) {
            elements->pop_back();
        } else {
            container.object()->pop_back();
        }
    }

    void require_distinct_names() const {
        const Json::Object& members = *open_.back()->object();
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

    template <class Value>
    void read_word(std::string_view word, Value value) {
        if (!text_.substr(at_).starts_with(word)) fail("expected a value");
        at_ += word.size();
        add(std::move(value));
    }

    std::string read_number() {
        const std::size_t start = at_;
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
        return std::string(text_.substr(start, at_ - start));
    }

    void skip_digits() {
        if (!is_digit(peek())) fail("expected a digit");
        while (is_digit(peek())) ++at_;
    }

    /// Reads what follows a quotation mark up to the next one.
    std::string read_string() {
        std::size_t start = at_;
        skip_plain();
        if (peek() == '"') return std::string(text_.substr(start, at_++ - start));
        std::string result;
        for (;;) {
            result += text_.substr(start, at_ - start);
            if (at_ == text_.size()) fail("the closing quotation mark is missing");
            start = at_;
            const char c = text_[at_];
            if (c == '"') break;
            if (c == '\\') {
                read_escape(result);
                start = at_;
            } else if (const std::size_t length = character_length(text_.substr(at_)); length > 1) {
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

    void skip_plain() {
        const auto is_plain = [](char c) { return plain_bytes[static_cast<unsigned char>(c)]; };
        at_ = static_cast<std::size_t>(std::ranges::find_if_not(text_.substr(at_), is_plain) - text_.begin());
    }

    void read_escape(std::string& result) {
        ++at_;
        constexpr std::string_view letters = "\"\\/bfnrt";
        constexpr std::string_view meanings = "\"\\/\b\f\n\r\t";
        const char letter = peek();
        if (const std::size_t i = letters.find(letter); at_ < text_.size() && i != std::string_view::npos) {
            ++at_;
            result += meanings[i];
            return;
        }
        if (letter != 'u') fail("a backslash in a string is followed by one of \"\\/bfnrtu");
        ++at_;
        std::uint32_t code = read_unit();
        if (code >= 0xDC00 && code <= 0xDFFF) fail("the second half of a character without the first");
        if (code >= 0xD800 && code <= 0xDBFF) {
            const bool escaped = text_.substr(at_).starts_with("\\u");
            if (escaped) at_ += 2;
            const std::uint32_t low = escaped ? read_unit() : 0;
            if (low < 0xDC00 || low > 0xDFFF) fail("the first half of a character without the second");
            code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
        }
        append_utf8(result, code);
    }

    /// The four hexadecimal digits of a unit of UTF-16.
    std::uint32_t read_unit() {
        constexpr std::size_t digits = 4;
        const std::string_view written = text_.substr(at_, digits);
        std::uint32_t unit = 0;
        const auto [end, problem] =
            std::from_chars(written.data(), written.data() + written.size(), unit, 16);
        const auto read = static_cast<std::size_t>(end - written.data());
        at_ += read;
        if (read < digits) fail("expected a hexadecimal digit");
        return unit;
    }

    /// The next byte; 0 at the end.
    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

    void skip_spaces() {
        while (at_ < text_.size() && is_space(text_[at_])) ++at_;
    }

    bool take(char c) {
        skip_spaces();
        if (peek() != c) return false;
        ++at_;
        return true;
    }

    void expect(char c, const char* rule) {
        if (!take(c)) fail(rule);
    }

    [[noreturn]] void fail(std::string_view rule) const {
        const std::string found =
            at_ < text_.size() ? ", found " + quoted(first_character(text_.substr(at_))) : ", the text ends";
        throw Error(ErrorCode::syntax, "byte " + std::to_string(at_ + 1) + ": " + std::string(rule) + found,
                    {}, at_);
    }

    std::string_view text_;
    const Limits& limits_;
    std::size_t at_ = 0;
    Json::Array read_;         ///< the value, once it has begun
    std::vector<Json*> open_;  ///< the containers around the place that is being read
    std::string name_;         ///< of the member whose value is being read
};

}  // namespace

JsonReading read_json(std::string_view text, const Limits& limits) { return Reader(text, limits).read(); }

Json parse_json(std::string_view text, const Limits& limits) {
    JsonReading reading = read_json(text, limits);
    if (reading.error) throw Error(*reading.error);
    return std::move(reading.value);
}

}  // namespace blossom::protocol
