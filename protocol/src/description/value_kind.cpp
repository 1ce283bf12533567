#include "value_kind.hpp"

#include <algorithm>
#include <array>

#include "json/json_text.hpp"

namespace blossom::protocol {

namespace {

struct ValueEntry {
    std::string_view name;  ///< in a definition
    std::string_view text;
    std::string_view plural;
    std::string_view request;  ///< its JSON Schema; empty where there is no such value
    std::string_view result;
};

constexpr std::string_view text_schema = R"({"type": "string"})";
constexpr std::string_view boolean_schema = R"({"type": "boolean"})";

/// In the order of `ValueKind`.
constexpr auto value_entries = std::to_array<ValueEntry>({
    {"number", "number", "numbers",
     R"({
        "description": "A string p, p/q or an exact decimal, a JSON integer, or with field floats a JSON number",
        "type": ["string", "number"]
     })",
     R"({
        "description": "An exact number in lowest terms",
        "type": "string",
        "pattern": "^(0|-?[1-9][0-9]*(/([2-9]|[1-9][0-9]+))?)$"
     })"},
    {"count", "count", "counts",
     R"({
        "description": "A non-negative integer",
        "anyOf": [{"type": "integer", "minimum": 0}, {"type": "string", "pattern": "^[0-9]+$"}]
     })",
     R"({"type": "integer", "minimum": 0})"},
    {"integer", "integer", "integers", R"({"type": "integer"})", R"({"type": "integer"})"},
    {"boolean", "true or false", "booleans", boolean_schema, boolean_schema},
    {"flag", "true or false", "booleans", boolean_schema, R"({"const": true})"},
    {"no", "true or false", "booleans", R"({"const": false})", ""},
    {"text", "text", "texts", text_schema, text_schema},
    {"polynomial_text", "polynomial as text", "polynomials as texts", text_schema, ""},
    {"list_text", "list as text", "lists as texts", text_schema, ""},
    {"null", "null", "nulls", R"({"type": "null"})", R"({"type": "null"})"},
    {"any", "any JSON value", "JSON values", "true", "true"},
    {"point", "point", "points",
     R"({
        "description": "A number for a scalar map, an array of coordinates otherwise",
        "anyOf": [
            {"$ref": "#/$defs/number"},
            {"type": "array", "items": {"$ref": "#/$defs/number"}, "minItems": 1}
        ]
     })",
     R"({
        "anyOf": [
            {"$ref": "#/$defs/exact_number"},
            {"type": "array", "items": {"$ref": "#/$defs/exact_number"}, "minItems": 1}
        ]
     })"},
    {"interval", "interval", "intervals",
     R"({"type": "array", "items": {"$ref": "#/$defs/number"}, "minItems": 2, "maxItems": 2})",
     R"({"type": "array", "items": {"$ref": "#/$defs/exact_number"}, "minItems": 2, "maxItems": 2})"},
    {"nested_points", "nested lists of points", "nested lists of points",
     R"({"anyOf": [{"$ref": "#/$defs/number"}, {"type": "array", "items": {"$ref": "#/$defs/nested_points"}}]})",
     R"({
        "anyOf": [
            {"$ref": "#/$defs/exact_number"},
            {"type": "array", "items": {"$ref": "#/$defs/exact_nested_points"}}
        ]
     })"},
    {"sample", "pair [number, point]", "pairs [number, point]",
     R"({
        "type": "array",
        "prefixItems": [{"$ref": "#/$defs/number"}, {"$ref": "#/$defs/point"}],
        "minItems": 2,
        "maxItems": 2
     })",
     ""},
    {"argument", "argument", "arguments",
     R"({
        "description": "A parameter, a vector (mass 0) or a pair with any mass",
        "anyOf": [
            {"$ref": "#/$defs/number"},
            {
                "type": "object",
                "properties": {"vector": {"$ref": "#/$defs/number"}},
                "required": ["vector"],
                "additionalProperties": false
            },
            {
                "type": "object",
                "properties": {
                    "homogeneous": {"type": "array", "items": {"$ref": "#/$defs/number"}, "minItems": 2, "maxItems": 2}
                },
                "required": ["homogeneous"],
                "additionalProperties": false
            }
        ]
     })",
     R"({
        "anyOf": [
            {"$ref": "#/$defs/exact_number"},
            {
                "type": "object",
                "properties": {
                    "homogeneous": {
                        "type": "array", "items": {"$ref": "#/$defs/exact_number"}, "minItems": 2, "maxItems": 2
                    }
                },
                "required": ["homogeneous"],
                "additionalProperties": false
            }
        ]
     })"},
    {"point_argument", "argument with coordinates", "arguments with coordinates",
     R"({
        "description": "A point, a vector or a point with a mass, as arrays of numbers",
        "anyOf": [
            {"type": "array", "items": {"$ref": "#/$defs/number"}},
            {
                "type": "object",
                "properties": {"vector": {"type": "array", "items": {"$ref": "#/$defs/number"}}},
                "required": ["vector"],
                "additionalProperties": false
            },
            {
                "type": "object",
                "properties": {"homogeneous": {"type": "array", "items": {"$ref": "#/$defs/number"}}},
                "required": ["homogeneous"],
                "additionalProperties": false
            }
        ]
     })",
     R"({"type": "array", "items": {"$ref": "#/$defs/exact_number"}})"},
    {"doubles", "doubles", "doubles",
     R"({
        "description": "What another program has computed: doubles, as JSON numbers or strings",
        "anyOf": [{"type": ["number", "string"]}, {"type": "array", "items": {"$ref": "#/$defs/doubles"}}]
     })",
     ""},
    {"nearest_double", "double", "doubles", "", R"({"type": "number"})"},
    {"document", "document", "documents", "true", R"({"type": ["object", "array", "string"]})"},
    {"map", "map", "maps", R"({"$ref": "#/$defs/map"})", R"({"$ref": "#/$defs/exact_map"})"},
});

const ValueEntry& entry_of(ValueKind kind) { return value_entries[static_cast<std::size_t>(kind)]; }

std::string_view fragment(const ValueEntry& entry, Side side) {
    return side == Side::request ? entry.request : entry.result;
}

std::string definition_name(const ValueEntry& entry, Side side) {
    return (side == Side::request ? "" : "exact_") + std::string(entry.name);
}

/// Whether a schema is written where it is used, being no longer than a reference to it.
bool stands_alone(std::string_view schema) {
    constexpr std::size_t longest = 36;
    return schema.size() <= longest;
}

}  // namespace

std::string_view text_of(ValueKind kind) { return entry_of(kind).text; }
std::string_view plural_of(ValueKind kind) { return entry_of(kind).plural; }

Json schema_of(ValueKind kind, Side side) {
    const ValueEntry& entry = entry_of(kind);
    const std::string_view schema = fragment(entry, side);
    if (schema.empty()) return {};
    return stands_alone(schema) ? parse_json(schema, Limits{}) : reference_to(definition_name(entry, side));
}

Json::Object value_definitions() {
    Json::Object definitions;
    for (const Side side : {Side::request, Side::result}) {
        for (const ValueEntry& entry : value_entries) {
            const std::string_view schema = fragment(entry, side);
            if (!stands_alone(schema))
                definitions.emplace_back(definition_name(entry, side), parse_json(schema, Limits{}));
        }
    }
    return definitions;
}

Json reference_to(std::string_view name) { return Json::Object{{"$ref", "#/$defs/" + std::string(name)}}; }

}  // namespace blossom::protocol
