#include <blossom/worked/json.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>

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

class Writer {
public:
    explicit Writer(std::optional<std::size_t> indent) : indent_(indent) {}

    void write(const Json& value) {
        if (value.is_null()) {
            text += "null";
        } else if (const bool* truth = value.boolean()) {
            text += *truth ? "true" : "false";
        } else if (const Json::Number* number = value.number()) {
            text += number->text;
        } else if (const Rational* exact = value.exact()) {
            text += '"' + to_string(*exact) + '"';
        } else if (const std::string* characters = value.text()) {
            text +=
                nlohmann::json(*characters).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
        } else if (const Json::Array* elements = value.array()) {
            list("[]", *elements, [&](const Json& element) { write(element); });
        } else {
            list("{}", *value.object(), [&](const Json::Member& member) {
                write(member.first);
                text += ": ";
                write(member.second);
            });
        }
    }

    std::string text;

private:
    void list(std::string_view brackets, const auto& entries, const auto& write_entry) {
        text += brackets[0];
        ++level_;
        for (const auto& entry : entries) {
            if (&entry != &entries.front()) text += indent_ ? "," : ", ";
            begin_line();
            write_entry(entry);
        }
        --level_;
        if (!entries.empty()) begin_line();
        text += brackets[1];
    }
    void begin_line() {
        if (indent_) text += '\n' + std::string(*indent_ * level_, ' ');
    }

    std::optional<std::size_t> indent_;
    std::size_t level_ = 0;
};

}  // namespace

std::string to_text(const Json& value, std::optional<std::size_t> indent) {
    Writer writer(indent);
    writer.write(value);
    return std::move(writer.text);
}

}  // namespace blossom
