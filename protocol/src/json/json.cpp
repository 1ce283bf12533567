#include <blossom/protocol/json.hpp>

#include <algorithm>
#include <charconv>

namespace blossom::protocol {

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

std::string_view type_name(const Json& value) {
    if (value.is_null()) return "null";
    if (value.boolean()) return "a boolean";
    if (value.number()) return "a number";
    if (value.array()) return "an array";
    if (value.object()) return "an object";
    return "a string";
}

std::string pointer_token(std::string_view name) {
    std::string token = "/";
    for (const char c : name) {
        if (c == '~') {
            token += "~0";
        } else if (c == '/') {
            token += "~1";
        } else {
            token += c;
        }
    }
    return token;
}

namespace {

const Json* child(const Json& value, std::string_view token) {
    if (const Json::Array* elements = value.array()) {
        std::size_t index = elements->size();
        std::from_chars(token.data(), token.data() + token.size(), index);
        return index < elements->size() ? &(*elements)[index] : nullptr;
    }
    const Json::Object* members = value.object();
    if (!members) return nullptr;
    const auto named = [&](const Json::Member& member) {
        return std::string_view(pointer_token(member.first)).substr(1) == token;
    };
    const auto found = std::ranges::find_if(*members, named);
    return found == members->end() ? nullptr : &found->second;
}

}  // namespace

const Json* at_pointer(const Json& value, std::string_view pointer) {
    const Json* place = &value;
    while (place && !pointer.empty()) {
        pointer.remove_prefix(1);
        const std::size_t length = std::min(pointer.find('/'), pointer.size());
        place = child(*place, pointer.substr(0, length));
        pointer.remove_prefix(length);
    }
    return place;
}

}  // namespace blossom::protocol
