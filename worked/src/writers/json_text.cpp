#include <blossom/worked/json.hpp>
#include <blossom/worked/json_characters.hpp>

#include <blossom/rational/utf8.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <type_traits>

namespace blossom {

const Json* Json::find(std::string_view name) const {
    const Object* members = object();
    if (!members) return nullptr;
    for (const auto& [own, value] : *members) {
        if (own == name) return &value;
    }
    return nullptr;
}

Json& Json::operator[](std::string_view name) {
    if (is_null()) value_ = Object{};
    auto& members = std::get<Object>(value_);
    const auto found = std::ranges::find(members, name, &Member::first);
    if (found != members.end()) return found->second;
    return members.emplace_back(std::string(name), Json()).second;
}

namespace {

/// A text that grows; what is short gathers in a part of it that has no bounds to check.
class GrowingText {
public:
    [[gnu::always_inline]] void put(char c) {
        if (used_ == part_.size()) flush();
        part_[used_++] = c;
    }
    void put(std::string_view characters) {
        if (characters.size() <= part_.size()) {
            put_while(characters, [](char) { return true; });
        } else {
            flush();
            text_ += characters;
        }
    }
    /// Puts the first characters, as long as they are wanted and there is room; their count, at least 1 if
    /// the first one is wanted.
    std::size_t put_while(std::string_view characters, const auto& is_wanted) {
        const std::span<char> to = room(std::min(characters.size(), part_.size()));
        const std::size_t most = std::min(characters.size(), to.size());
        std::size_t length = 0;
        for (; length < most && is_wanted(characters[length]); ++length) to[length] = characters[length];
        used_ += length;
        return length;
    }
    void put(std::int64_t value) {
        constexpr std::size_t most_characters = 20;
        const std::span<char> to = room(most_characters);
        used_ +=
            static_cast<std::size_t>(std::to_chars(to.data(), to.data() + to.size(), value).ptr - to.data());
    }
    std::string finish() && {
        flush();
        return std::move(text_);
    }

private:
    /// The rest of the part, at least so many characters.
    std::span<char> room(std::size_t least) {
        if (part_.size() - used_ < least) flush();
        return std::span(part_).subspan(used_);
    }
    void flush() {
        text_.append(part_.data(), used_);
        used_ = 0;
    }

    std::string text_;
    std::array<char, 512> part_{};
    std::size_t used_ = 0;
};

void put_integer(GrowingText& text, const Integer& value) {
    value.is_word() ? text.put(value.word()) : text.put(to_string(value));
}

void put_escape(GrowingText& text, char c) {
    constexpr std::string_view meanings = "\"\\\b\f\n\r\t";
    constexpr std::string_view letters = "\"\\bfnrt";
    text.put('\\');
    if (const std::size_t i = meanings.find(c); i != std::string_view::npos) {
        text.put(letters[i]);
    } else {
        constexpr std::string_view hex = "0123456789abcdef";
        const auto byte = static_cast<unsigned char>(c);
        text.put("u00");
        text.put(hex[byte >> 4]);
        text.put(hex[byte & 15]);
    }
}

void put_string(GrowingText& text, std::string_view value) {
    constexpr std::string_view replacement = "\uFFFD";
    text.put('"');
    while (!value.empty()) {
        value.remove_prefix(text.put_while(value, is_plain_in_json));
        if (value.empty() || is_plain_in_json(value.front())) continue;
        const std::size_t length = character_length(value);
        if (length == 1) {
            put_escape(text, value.front());
        } else {
            text.put(length == 0 ? replacement : value.substr(0, length));
        }
        value.remove_prefix(std::max<std::size_t>(length, 1));
    }
    text.put('"');
}

/// Writes a `Json`, or one that is not const and is emptied by it: each value is freed when it is written.
template <class Value>
class Writer {
public:
    explicit Writer(std::optional<std::size_t> indent) : indent_(indent) {}

    void write(Value& value) {
        if (value.is_null()) {
            text.put("null");
        } else if (const bool* truth = value.boolean()) {
            text.put(*truth ? "true" : "false");
        } else if (const Json::Number* number = value.number()) {
            text.put(number->text);
        } else if (const Rational* exact = value.exact()) {
            text.put('"');
            put_integer(text, exact->numerator());
            if (!exact->is_integer()) {
                text.put('/');
                put_integer(text, exact->denominator());
            }
            text.put('"');
        } else if (const std::string* characters = value.text()) {
            put_string(text, *characters);
        } else if (auto* elements = value.array()) {
            list("[]", *elements, [&](Value& element) { write(element); });
        } else {
            list("{}", *value.object(), [&](auto& member) {
                put_string(text, member.first);
                text.put(':');
                text.put(' ');
                write(member.second);
            });
        }
        if constexpr (!std::is_const_v<Value>) value.clear();
    }

    GrowingText text;

private:
    void list(std::string_view brackets, auto& entries, const auto& write_entry) {
        text.put(brackets[0]);
        ++level_;
        for (auto& entry : entries) {
            if (&entry != &entries.front()) {
                text.put(',');
                if (!indent_) text.put(' ');
            }
            begin_line();
            write_entry(entry);
        }
        --level_;
        if (!entries.empty()) begin_line();
        text.put(brackets[1]);
    }
    void begin_line() {
        if (!indent_) return;
        text.put('\n');
        for (std::size_t i = 0; i < *indent_ * level_; ++i) text.put(' ');
    }

    std::optional<std::size_t> indent_;
    std::size_t level_ = 0;
};

}  // namespace

std::string to_text(const Json& value, std::optional<std::size_t> indent) {
    Writer<const Json> writer(indent);
    writer.write(value);
    return std::move(writer.text).finish();
}

std::string to_text(Json&& value) {
    Writer<Json> writer({});
    writer.write(value);
    return std::move(writer.text).finish();
}

}  // namespace blossom
