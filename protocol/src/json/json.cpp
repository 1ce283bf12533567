#include <blossom/protocol/json.hpp>

#include <algorithm>
#include <charconv>

namespace blossom::protocol {

std::string_view type_name(const Json& value) {
    if (value.is_null()) return "null";
    if (value.boolean()) return "a boolean";
    if (value.number()) return "a number";
    if (value.array()) return "an array";
    if (value.object()) return "an object";
    return "a string";
}

namespace {

std::string token_of(std::string_view name) {
    std::string token;
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

const Json* child(const Json& value, std::string_view token) {
    if (const Json::Array* elements = value.array()) {
        std::size_t index = elements->size();
        std::from_chars(token.data(), token.data() + token.size(), index);
        return index < elements->size() ? &(*elements)[index] : nullptr;
    }
    const Json::Object* members = value.object();
    if (!members) return nullptr;
    const auto named = [&](const Json::Member& member) { return token_of(member.first) == token; };
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

namespace {

std::string_view member_name(const Place::Step& step) {
    const Part* part = std::get_if<Part>(&step);
    return part ? part_name(*part) : std::string_view(std::get<std::string>(step));
}

const Json* at_step(const Json& value, const Place::Step& step) {
    const auto* index = std::get_if<std::size_t>(&step);
    if (!index) return value.find(member_name(step));
    const Json::Array* elements = value.array();
    return elements && *index < elements->size() ? &(*elements)[*index] : nullptr;
}

}  // namespace

const Json* at_place(const Json& value, const Place& place) {
    const Json* found = &value;
    for (const Place::Step& step : place.steps()) {
        found = at_step(*found, step);
        if (!found) return nullptr;
    }
    return found;
}

Place present_part(const Json& value, const Place& place) {
    Place present;
    const Json* found = &value;
    for (const Place::Step& step : place.steps()) {
        found = at_step(*found, step);
        if (!found) break;
        present = present.around({step});
    }
    return present;
}

std::string pointer_of(const Place& place) {
    std::string pointer;
    for (const Place::Step& step : place.steps()) {
        const auto* index = std::get_if<std::size_t>(&step);
        pointer += '/';
        pointer += index ? std::to_string(*index) : token_of(member_name(step));
    }
    return pointer;
}

}  // namespace blossom::protocol
