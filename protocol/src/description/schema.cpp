#include <algorithm>
#include <iterator>

#include <blossom/protocol/description.hpp>
#include "json/json_text.hpp"
#include "maps/kind.hpp"
#include "operations/operation.hpp"
#include "responses.hpp"

namespace blossom::protocol {

namespace {

Json constant(std::string_view word) { return Json::Object{{"const", word}}; }

Json any_of(const std::vector<std::string>& names) {
    Json::Array references;
    for (const std::string& name : names) references.push_back(reference_to(name));
    return Json::Object{{"anyOf", std::move(references)}};
}

/// Numbers that are rounded: as doubles, and as hexadecimal floats.
Json::Object rounded_definitions() {
    constexpr std::string_view rounded = R"({
        "anyOf": [
            {"type": "number"},
            {"description": "The ends of unbounded intervals stay", "enum": ["-inf", "inf"]},
            {"type": "array", "items": {"$ref": "#/$defs/rounded"}}
        ]
    })";
    constexpr std::string_view hexadecimal = R"({
        "anyOf": [
            {"type": "string", "pattern": "^-?0x[01](\\.[0-9a-f]+)?p[-+][0-9]+$"},
            {"description": "The indices and exponents beside the numbers stay", "type": "integer"},
            {"enum": ["-inf", "inf"]},
            {"type": "array", "items": {"$ref": "#/$defs/rounded_hexadecimal"}}
        ]
    })";
    return {{"rounded", parse_json(rounded, Limits{})},
            {"rounded_hexadecimal", parse_json(hexadecimal, Limits{})}};
}

/// Each kind of map and, on this side, any map.
void add_maps(Json::Object& definitions, Side side) {
    const std::string prefix = side == Side::request ? "" : "exact_";
    std::vector<std::string> names;
    for (const Kind* kind : Kinds::all) {
        for (const KindWord& word : words_of(*kind)) {
            Json schema = object_schema(word.members(), side, {{"kind", constant(word.word)}});
            if (schema.is_null()) continue;
            names.push_back(prefix + title_of(word, "_with_"));
            definitions.emplace_back(names.back(), std::move(schema));
        }
    }
    definitions.emplace_back(prefix + "map", any_of(names));
}

void add_operations(Json::Object& definitions) {
    std::vector<std::string> requests;
    std::vector<std::string> results;
    for (const Operation& operation : operations()) {
        Members request = operation.request;
        std::ranges::move(common_fields(), std::back_inserter(request.fields));
        Json schema = object_schema(request, Side::request, {{"op", constant(operation.name)}});
        schema["description"] = std::string(operation.summary) + ". " + std::string(operation.documentation);
        requests.push_back(std::string(operation.name) + "_request");
        definitions.emplace_back(requests.back(), std::move(schema));
        results.push_back(std::string(operation.name) + "_result");
        definitions.emplace_back(results.back(), object_schema(operation.result, Side::result));
    }
    constexpr std::string_view exact = R"({
        "description": "Without field floats JSON numbers are integers, but for what another program computed",
        "if": {"type": "object", "required": ["floats"]},
        "else": {"anyOf": [
            {"type": ["string", "integer", "boolean", "null"]},
            {"type": "array", "items": {"$ref": "#/$defs/written_exactly"}},
            {
                "type": "object",
                "properties": {"id": true, "computed": true, "document": true},
                "additionalProperties": {"$ref": "#/$defs/written_exactly"}
            }
        ]}
    })";
    definitions.emplace_back("written_exactly", parse_json(exact, Limits{}));
    definitions.emplace_back(
        "request", Json::Object{{"allOf", Json::Array{any_of(requests), reference_to("written_exactly")}}});
    definitions.emplace_back("result", any_of(results));
}

Json error_schema() {
    std::vector<std::string_view> codes;
    for (int code = 0; code <= static_cast<int>(ErrorCode::internal); ++code) {
        // Spaces are not named in requests.
        if (static_cast<ErrorCode>(code) != ErrorCode::different_spaces)
            codes.push_back(error_name(static_cast<ErrorCode>(code)));
    }
    return object_schema(
        {{{"code", Shape::words(std::move(codes)), Presence::required, "what is wrong"},
          {"message", ValueKind::text, Presence::required, "the same as a sentence"},
          {"at", ValueKind::text, Presence::required, "a JSON Pointer into the request"},
          {"limit", ValueKind::text, Presence::optional, "the name of the limit that is exceeded"},
          {"flag", ValueKind::text, Presence::optional, "the flag of the program that raises it"}}},
        Side::result);
}

Json response_schema(bool ok, std::string_view member) {
    return Json::Object{{"type", "object"},
                        {"properties", Json::Object{{"ok", Json::Object{{"const", ok}}},
                                                    {std::string(member), reference_to(member)},
                                                    {"id", true}}},
                        {"required", Json::Array{"ok", member}},
                        {"additionalProperties", false}};
}

std::vector<FieldDescription> described(const Members& members) {
    std::vector<FieldDescription> descriptions;
    for (const Field& field : all_fields(members)) {
        descriptions.push_back({std::string(field.name), field.shape.text(), field.shape.alternatives(),
                                presence_text(members, field.name) == "yes", field.documentation});
    }
    return descriptions;
}

}  // namespace

const std::vector<OperationDescription>& operation_descriptions() {
    static const std::vector<OperationDescription> descriptions = [] {
        std::vector<OperationDescription> list;
        for (const Operation& operation : operations()) {
            list.push_back({std::string(operation.name), std::string(operation.summary),
                            std::string(operation.documentation), described(operation.request),
                            described(operation.result)});
        }
        return list;
    }();
    return descriptions;
}

Json schema() {
    Json::Object definitions = value_definitions();
    std::ranges::move(rounded_definitions(), std::back_inserter(definitions));
    add_maps(definitions, Side::request);
    add_maps(definitions, Side::result);
    add_operations(definitions);
    definitions.emplace_back("error", error_schema());
    definitions.emplace_back("response",
                             Json::Object{{"oneOf", Json::Array{response_schema(true, "result"),
                                                                response_schema(false, "error")}}});
    return Json::Object{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                        {"title", "The blossom protocol: a request or a response on each line"},
                        {"anyOf", Json::Array{reference_to("request"), reference_to("response")}},
                        {"$defs", std::move(definitions)}};
}

}  // namespace blossom::protocol
