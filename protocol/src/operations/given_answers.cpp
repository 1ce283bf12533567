#include "given_answers.hpp"

#include <blossom/rational/lists.hpp>

#include "floats.hpp"
#include "json/json_text.hpp"
#include "map_options.hpp"
#include "rounding.hpp"

namespace blossom::protocol {

namespace {

bool is_answer(const Json& given) {
    return given.object() && given.find("ok") && (given.find("result") || given.find("error"));
}

/// The result of an answer.
const Json& result_of_answer(const Json& answer) {
    if (const Json* message = at_place(answer, {"error", "message"}); message && message->text())
        throw UsageError("the answer that is given is an error: " + *message->text());
    const Json* result = answer.find("result");
    if (!result || !result->object()) throw UsageError("the answer that is given has no result");
    return *result;
}

[[noreturn]] void refuse_answer(const Json& result, std::string_view wanted) {
    std::vector<std::string_view> names;
    for (const auto& [name, member] : *result.object()) {
        if (!is_rounded_twin(name)) names.push_back(name);
    }
    throw UsageError("the answer that is given has no " + std::string(wanted) + ", but " + joined(names));
}

Json without_twins(const Json& value) {
    if (const Json::Array* elements = value.array()) return Json::Array(mapped(*elements, without_twins));
    const Json::Object* members = value.object();
    if (!members) return value;
    Json::Object kept;
    for (const auto& [name, member] : *members) {
        if (!is_rounded_twin(name)) kept.emplace_back(name, without_twins(member));
    }
    return kept;
}

/// The members with each number as its double, where the answer has it, and else as the exact number.
Json with_twins(const Json& members, const Limits& limits) {
    Json::Object doubles;
    for (const auto& [name, member] : *members.object()) {
        if (is_rounded_twin(name)) continue;
        const Json* twin = nullptr;
        for (const Rounding rounding : {Rounding::binary64, Rounding::hexadecimal}) {
            if (!twin) twin = members.find(name + std::string(rounding_suffix(rounding)));
        }
        doubles.emplace_back(name, twin              ? *twin
                                   : member.object() ? with_twins(member, limits)
                                                     : with_decimals(member, limits));
    }
    return doubles;
}

}  // namespace

std::vector<Json> maps_in(const Json& given) {
    if (!is_answer(given)) return given.array() ? *given.array() : Json::Array{given};
    const Json& result = result_of_answer(given);
    if (const Json* map = result.find("map")) return {without_twins(*map)};
    const Json* maps = result.find("maps");
    if (maps && maps->array()) return mapped(*maps->array(), without_twins);
    refuse_answer(result, "map");
}

Json document_in(const Json& given) {
    if (!is_answer(given)) return given;
    const Json& result = result_of_answer(given);
    const Json* document = result.find("document");
    if (!document) refuse_answer(result, "document");
    return *document;
}

Json computed_in(const Json& given, const Limits& limits) {
    if (!is_answer(given)) return given;
    const Json& result = result_of_answer(given);
    const Json* map = result.find("map");
    Json members = with_twins(map ? *map : result, limits);
    std::erase_if(*members.object(), [](const Json::Member& member) {
        return member.first == "kind" || member.first == "degree" || member.first == "degrees" ||
               member.first == "homogeneous" || member.first == "variables";
    });
    return members;
}

std::optional<Json> list_in_answer(std::string_view text, std::string_view field, const Limits& limits) {
    if (!trimmed(text).starts_with('{')) return std::nullopt;
    const Json given = parse_json(text, limits);
    if (!is_answer(given)) return std::nullopt;
    const Json& result = result_of_answer(given);
    const Json* list = result.find(field);
    if (field == "at") {
        for (const char* name : {"nodes", "coordinates"}) {
            if (!list) list = result.find(name);
        }
    }
    if (!list) refuse_answer(result, field);
    return *list;
}

}  // namespace blossom::protocol
