#include <blossom/worked/json.hpp>

#include <blossom/rational/utf8.hpp>

#include <algorithm>
#include <type_traits>

namespace blossom {

const Json* Json::find(std::string_view name) const {
    const Object* members = object();
    if (!members) return nullptr;
    const auto found = std::ranges::find(*members, name, &Member::first);
    return found == members->end() ? nullptr : &found->second;
}

Json& Json::operator[](std::string_view name) {
    if (is_null()) value_ = Object{};
    auto& members = std::get<Object>(value_);
    const auto found = std::ranges::find(members, name, &Member::first);
    if (found != members.end()) return found->second;
    return members.emplace_back(std::string(name), Json()).second;
}

namespace {

void append_escape(std::string& text, char c) {
    constexpr std::string_view meanings = "\"\\\b\f\n\r\t";
    constexpr std::string_view letters = "\"\\bfnrt";
    text += '\\';
    if (const std::size_t i = meanings.find(c); i != std::string_view::npos) {
        text += letters[i];
    } else {
        constexpr std::string_view hex = "0123456789abcdef";
        const auto byte = static_cast<unsigned char>(c);
        text += "u00";
        text += hex[byte >> 4];
        text += hex[byte & 15];
    }
}

void append_string(std::string& text, std::string_view value) {
    constexpr std::string_view replacement = "\uFFFD";
    const auto is_plain = [](char c) {
        return static_cast<unsigned char>(c) >= 0x20 && static_cast<unsigned char>(c) < 0x80 && c != '"' &&
               c != '\\';
    };
    text += '"';
    while (!value.empty()) {
        const auto plain =
            static_cast<std::size_t>(std::ranges::find_if_not(value, is_plain) - value.begin());
        text += value.substr(0, plain);
        value.remove_prefix(plain);
        if (value.empty()) break;
        const std::size_t length = character_length(value);
        if (length == 1) {
            append_escape(text, value.front());
        } else {
            text += length == 0 ? replacement : value.substr(0, length);
        }
        value.remove_prefix(std::max<std::size_t>(length, 1));
    }
    text += '"';
}

/// Writes a `Json`, or one that is not const and is emptied by it: each value is freed when it is written.
template <class Value>
class Writer {
public:
    explicit Writer(std::optional<std::size_t> indent) : indent_(indent) {
        constexpr std::size_t usual_size = 120;
        text.reserve(usual_size);
    }

    void write(Value& value) {
        if (value.is_null()) {
            text += "null";
        } else if (const bool* truth = value.boolean()) {
            text += *truth ? "true" : "false";
        } else if (const Json::Number* number = value.number()) {
            text += number->text;
        } else if (const Rational* exact = value.exact()) {
            text += '"';
            text += to_string(*exact);
            text += '"';
        } else if (const std::string* characters = value.text()) {
            append_string(text, *characters);
        } else if (auto* elements = value.array()) {
            list("[]", *elements, [&](Value& element) { write(element); });
        } else {
            list("{}", *value.object(), [&](auto& member) {
                append_string(text, member.first);
                text += ": ";
                write(member.second);
            });
        }
        if constexpr (!std::is_const_v<Value>) value.clear();
    }

    std::string text;

private:
    void list(std::string_view brackets, auto& entries, const auto& write_entry) {
        text += brackets[0];
        ++level_;
        for (auto& entry : entries) {
            if (&entry != &entries.front()) text += indent_ ? "," : ", ";
            begin_line();
            write_entry(entry);
        }
        --level_;
        if (!entries.empty()) begin_line();
        text += brackets[1];
    }
    void begin_line() {
        if (indent_) text.append(1, '\n').append(*indent_ * level_, ' ');
    }

    std::optional<std::size_t> indent_;
    std::size_t level_ = 0;
};

}  // namespace

std::string to_text(const Json& value, std::optional<std::size_t> indent) {
    Writer<const Json> writer(indent);
    writer.write(value);
    return std::move(writer.text);
}

std::string to_text(Json&& value) {
    Writer<Json> writer({});
    writer.write(value);
    return std::move(writer.text);
}

}  // namespace blossom
