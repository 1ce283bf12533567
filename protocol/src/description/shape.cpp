#include "shape.hpp"

#include <algorithm>
#include <array>
#include <iterator>

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
constexpr auto entries = std::to_array<ValueEntry>({
    {"number", "number", "numbers",
     R"({
        "description": "An exact number: a string p, p/q or an exact decimal, or a JSON integer",
        "anyOf": [{"type": "string"}, {"type": "integer"}]
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
    {"document", "document", "documents", "true", R"({"type": "object"})"},
    {"map", "map", "maps", R"({"$ref": "#/$defs/map"})", R"({"$ref": "#/$defs/exact_map"})"},
});

const ValueEntry& entry_of(ValueKind kind) { return entries[static_cast<std::size_t>(kind)]; }

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

Json value_schema(ValueKind kind, Side side) {
    const ValueEntry& entry = entry_of(kind);
    const std::string_view schema = fragment(entry, side);
    if (schema.empty()) return {};
    return stands_alone(schema) ? parse_json(schema, Limits{}) : reference_to(definition_name(entry, side));
}

template <class Range>
std::string joined(const Range& parts, std::string_view last_separator) {
    std::string text;
    std::size_t place = 0;
    for (const auto& part : parts) {
        if (place > 0) text += place + 1 == parts.size() ? last_separator : ", ";
        text += part;
        ++place;
    }
    return text;
}

std::vector<std::string> quoted_words(const std::vector<std::string_view>& words, std::string_view quote) {
    std::vector<std::string> list;
    for (const std::string_view word : words) list.push_back(std::string(quote).append(word).append(quote));
    return list;
}

std::shared_ptr<const Shape> shared(Shape shape) { return std::make_shared<const Shape>(std::move(shape)); }

Json array_schema(Json element, std::size_t least, std::size_t most) {
    if (element.is_null()) return {};
    Json schema = Json::Object{{"type", "array"}, {"items", std::move(element)}};
    if (least > 0) schema["minItems"] = least;
    if (most != SIZE_MAX) schema["maxItems"] = most;
    return schema;
}

template <class... Functions>
struct Cases : Functions... {
    using Functions::operator()...;
};

bool is_required(const Field& field, Side side) {
    return field.presence == Presence::required ||
           (field.presence == Presence::defaulted && side == Side::result);
}

Json schema_of(const Field& field, Side side) {
    Json schema = field.shape.schema(side);
    if (schema.is_null() || !schema.object()) return schema;
    // What stands beside a reference applies too.
    if (!schema.find("description")) schema["description"] = field.documentation;
    return schema;
}

bool is_possible(const Field& field, Side side) { return !field.shape.schema(side).is_null(); }

/// Whether an object can have all fields that it must have.
bool are_possible(const FieldList& fields, Side side) {
    return std::ranges::all_of(
        fields, [&](const Field& field) { return !is_required(field, side) || is_possible(field, side); });
}

const Field* find_in(const FieldList& fields, std::string_view name) {
    const auto found = std::ranges::find(fields, name, &Field::name);
    return found == fields.end() ? nullptr : &*found;
}

/// The names that occur in a choice, in their order.
std::vector<std::string_view> names_in(const Choice& choice) {
    std::vector<std::string_view> names;
    for (const FieldList& fields : choice) {
        for (const Field& field : fields) {
            if (std::ranges::find(names, field.name) == names.end()) names.push_back(field.name);
        }
    }
    return names;
}

/// What the schema of an object is made of.
class ObjectSchema {
public:
    ObjectSchema(Side side, const Json::Object& first) : side_(side), properties_(first) {
        for (const auto& [name, schema] : first) required_.emplace_back(name);
    }

    void add(const FieldList& fields) {
        for (const Field& field : fields) {
            if (!is_possible(field, side_)) continue;
            properties_.emplace_back(field.name, schema_of(field, side_));
            if (is_required(field, side_)) required_.emplace_back(field.name);
            has_numbers_ = has_numbers_ || field.shape.has_numbers();
        }
    }
    void add(Choice choice) {
        std::erase_if(choice, [&](const FieldList& fields) { return !are_possible(fields, side_); });
        if (choice.size() == 1) {
            add(choice.front());
            return;
        }
        std::vector<std::string_view> differing;
        for (const std::string_view name : names_in(choice)) {
            std::vector<Json> schemas;
            for (const FieldList& fields : choice) {
                const Field* field = find_in(fields, name);
                if (!field || !is_possible(*field, side_)) continue;
                schemas.push_back(schema_of(*field, side_));
                has_numbers_ = has_numbers_ || field->shape.has_numbers();
            }
            if (schemas.empty()) continue;
            const bool same = std::ranges::count(schemas, schemas.front()) == std::ssize(schemas);
            if (!same) differing.push_back(name);
            properties_.emplace_back(name, same ? schemas.front() : Json(true));
        }
        Json::Array branches;
        for (const FieldList& fields : choice)
            branches.push_back(branch(fields, names_in(choice), differing));
        choices_.emplace_back(Json::Object{{"anyOf", std::move(branches)}});
    }
    Json finished(bool some) && {
        Json schema = Json::Object{{"type", "object"}, {"properties", std::move(properties_)}};
        if (!required_.empty()) schema["required"] = std::move(required_);
        if (some) schema["minProperties"] = std::size_t{1};
        if (side_ == Side::result && has_numbers_) {
            schema["patternProperties"] = Json::Object{{"_double$", reference_to("rounded")},
                                                       {"_hex$", reference_to("rounded_hexadecimal")}};
        }
        schema["additionalProperties"] = false;
        if (choices_.size() == 1) schema["anyOf"] = *choices_.front().find("anyOf");
        if (choices_.size() > 1) schema["allOf"] = std::move(choices_);
        return schema;
    }

private:
    /// One of the sets of fields: what is required, and what is not there or otherwise there.
    Json branch(const FieldList& fields, const std::vector<std::string_view>& names,
                const std::vector<std::string_view>& differing) const {
        Json::Array required;
        Json::Object properties;
        for (const std::string_view name : names) {
            const Field* field = find_in(fields, name);
            if (!field || !is_possible(*field, side_)) {
                properties.emplace_back(name, false);
                continue;
            }
            if (is_required(*field, side_)) required.emplace_back(name);
            if (std::ranges::find(differing, name) != differing.end())
                properties.emplace_back(name, schema_of(*field, side_));
        }
        Json::Object schema;
        if (!required.empty()) schema.emplace_back("required", std::move(required));
        if (!properties.empty()) schema.emplace_back("properties", std::move(properties));
        return schema;
    }

    Side side_;
    Json::Object properties_;
    Json::Array required_;
    Json::Array choices_;
    bool has_numbers_ = false;
};

}  // namespace

Shape Shape::words(std::vector<std::string_view> words) { return Shape(Words{std::move(words)}); }
Shape Shape::list(Shape element, std::size_t least, std::size_t most) {
    return Shape(List{shared(std::move(element)), least, most});
}
Shape Shape::pair(Shape first, Shape second) {
    return Shape(Pair{shared(std::move(first)), shared(std::move(second))});
}
Shape Shape::one_of(std::vector<Shape> alternatives) { return Shape(OneOf{std::move(alternatives)}); }
Shape Shape::object(Members members) {
    return Shape(Object(std::make_shared<const Members>(std::move(members))));
}
Shape Shape::names(Shape member) { return Shape(Names{shared(std::move(member))}); }
Shape Shape::request_of(std::vector<std::string_view> operations) {
    return Shape(RequestOf{std::move(operations)});
}

Shape Shape::united(const Shape& first, const Shape& second) {
    const auto* words = std::get_if<Words>(&first.value_);
    const auto* more_words = std::get_if<Words>(&second.value_);
    if (words && more_words) {
        Words all = *words;
        for (const std::string_view word : more_words->words) {
            if (std::ranges::find(all.words, word) == all.words.end()) all.words.push_back(word);
        }
        return Shape(std::move(all));
    }
    std::vector<Shape> all;
    for (const Shape* shape : {&first, &second}) {
        const auto* one = std::get_if<OneOf>(&shape->value_);
        for (const Shape& alternative : one ? one->alternatives : std::vector{*shape}) {
            const bool is_new = std::ranges::none_of(
                all, [&](const Shape& other) { return other.text() == alternative.text(); });
            if (is_new) all.push_back(alternative);
        }
    }
    return all.size() == 1 ? all.front() : one_of(std::move(all));
}

std::vector<std::string_view> Shape::alternatives() const {
    const auto* words = std::get_if<Words>(&value_);
    return words ? words->words : std::vector<std::string_view>{};
}

std::string Shape::text(std::string_view quote) const {
    const auto both = [&](const Shape& first, const Shape& second) {
        return "[" + first.text(quote) + ", " + second.text(quote) + "]";
    };
    return std::visit(
        Cases{
            [](ValueKind kind) { return std::string(entry_of(kind).text); },
            [&](const Words& words) { return joined(quoted_words(words.words, quote), " or "); },
            [&](const List& list) { return "list of " + list.element->plural(quote); },
            [&](const Pair& pair) { return "pair " + both(*pair.first, *pair.second); },
            [&](const OneOf& one) {
                std::vector<std::string> texts;
                for (const Shape& shape : one.alternatives) texts.push_back(shape.text(quote));
                return joined(texts, " or ");
            },
            [](const Object&) { return std::string("object"); },
            [&](const Names& names) { return "object of " + names.member->plural(quote); },
            [&](const RequestOf& request) {
                return "request for " + joined(quoted_words(request.operations, quote), " or ");
            },
        },
        value_);
}

std::string Shape::plural(std::string_view quote) const {
    if (const auto* kind = std::get_if<ValueKind>(&value_)) return std::string(entry_of(*kind).plural);
    if (const auto* list = std::get_if<List>(&value_)) return "lists of " + list->element->plural(quote);
    if (const auto* one = std::get_if<OneOf>(&value_)) {
        std::vector<std::string> texts;
        for (const Shape& shape : one->alternatives) texts.push_back(shape.plural(quote));
        return joined(texts, " or ");
    }
    std::string singular = text(quote);
    const std::size_t end = std::min(singular.find(' '), singular.size());
    return std::holds_alternative<Words>(value_) ? singular : singular.insert(end, "s");
}

Json Shape::schema(Side side) const {
    return std::visit(
        Cases{
            [&](ValueKind kind) { return value_schema(kind, side); },
            [](const Words& words) -> Json {
                return Json::Object{{"enum", Json::Array(words.words.begin(), words.words.end())}};
            },
            [&](const List& list) { return array_schema(list.element->schema(side), list.least, list.most); },
            [&](const Pair& pair) -> Json {
                Json first = pair.first->schema(side);
                Json second = pair.second->schema(side);
                if (first.is_null() || second.is_null()) return {};
                return Json::Object{{"type", "array"},
                                    {"prefixItems", Json::Array{std::move(first), std::move(second)}},
                                    {"minItems", std::size_t{2}},
                                    {"maxItems", std::size_t{2}}};
            },
            [&](const OneOf& one) -> Json {
                Json::Array schemas;
                for (const Shape& shape : one.alternatives) schemas.push_back(shape.schema(side));
                std::erase(schemas, Json());
                if (schemas.size() <= 1) return schemas.empty() ? Json() : schemas.front();
                return Json::Object{{"anyOf", std::move(schemas)}};
            },
            [&](const Object& members) { return object_schema(*members, side); },
            [&](const Names& names) -> Json {
                Json member = names.member->schema(side);
                if (member.is_null()) return {};
                Json schema = Json::Object{{"type", "object"}};
                if (side == Side::result && names.member->has_numbers()) {
                    schema["patternProperties"] =
                        Json::Object{{"_double$", reference_to("rounded")},
                                     {"_hex$", reference_to("rounded_hexadecimal")}};
                }
                schema["additionalProperties"] = std::move(member);
                return schema;
            },
            [](const RequestOf& request) -> Json {
                Json::Array schemas;
                for (const std::string_view name : request.operations)
                    schemas.push_back(reference_to(std::string(name) + "_request"));
                return Json::Object{{"anyOf", std::move(schemas)}};
            },
        },
        value_);
}

bool Shape::has_numbers() const {
    return std::visit(
        Cases{
            [](ValueKind kind) {
                constexpr ValueKind numeric[] = {ValueKind::number,   ValueKind::point,
                                                 ValueKind::interval, ValueKind::nested_points,
                                                 ValueKind::argument, ValueKind::point_argument};
                return std::ranges::find(numeric, kind) != std::end(numeric);
            },
            [](const List& list) { return list.element->has_numbers(); },
            [](const Pair& pair) { return pair.first->has_numbers() || pair.second->has_numbers(); },
            [](const OneOf& one) { return std::ranges::any_of(one.alternatives, &Shape::has_numbers); },
            [](const auto&) { return false; },
        },
        value_);
}

FieldList all_fields(const Members& members) {
    FieldList all = members.fields;
    for (const Choice& choice : members.choices) {
        for (const FieldList& fields : choice) {
            for (const Field& field : fields) {
                const auto found = std::ranges::find(all, field.name, &Field::name);
                if (found == all.end()) {
                    all.push_back(field);
                } else {
                    found->shape = Shape::united(found->shape, field.shape);
                }
            }
        }
    }
    std::ranges::stable_partition(
        all, [&](const Field& field) { return presence_text(members, field.name) != "no"; });
    return all;
}

std::string presence_text(const Members& members, std::string_view name) {
    const auto is_yes = [&](const Field* field) { return field && is_required(*field, Side::request); };
    if (const Field* field = find_in(members.fields, name)) return is_yes(field) ? "yes" : "no";
    for (const Choice& choice : members.choices) {
        const auto having = std::ranges::count_if(
            choice, [&](const FieldList& fields) { return find_in(fields, name) != nullptr; });
        if (having == 0) continue;
        const auto requiring = std::ranges::count_if(
            choice, [&](const FieldList& fields) { return is_yes(find_in(fields, name)); });
        if (requiring == 0) return "no";
        if (requiring == std::ssize(choice)) return "yes";
        // With the field that says which of the sets is meant, or instead of those of the others.
        std::vector<std::string> others;
        for (const FieldList& fields : choice) {
            const bool own = find_in(fields, name) != nullptr;
            const auto sign = std::ranges::find_if(
                fields, [&](const Field& field) { return is_yes(&field) && field.name != name; });
            if (having > 1 && is_yes(find_in(fields, name)) && sign != fields.end())
                return "with `" + std::string(sign->name) + "`";
            if (!own && sign != fields.end()) others.push_back("`" + std::string(sign->name) + "`");
        }
        return others.empty() ? "no" : "or " + joined(others, " or ");
    }
    return "no";
}

Json object_schema(const Members& members, Side side, const Json::Object& first) {
    if (!are_possible(members.fields, side)) return {};
    for (const Choice& choice : members.choices) {
        if (std::ranges::none_of(choice, [&](const FieldList& fields) { return are_possible(fields, side); }))
            return {};
    }
    ObjectSchema schema(side, first);
    schema.add(members.fields);
    for (const Choice& choice : members.choices) schema.add(choice);
    return std::move(schema).finished(members.some);
}

Json::Object value_definitions() {
    Json::Object definitions;
    for (const Side side : {Side::request, Side::result}) {
        for (const ValueEntry& entry : entries) {
            const std::string_view schema = fragment(entry, side);
            if (!stands_alone(schema))
                definitions.emplace_back(definition_name(entry, side), parse_json(schema, Limits{}));
        }
    }
    return definitions;
}

Json reference_to(std::string_view name) { return Json::Object{{"$ref", "#/$defs/" + std::string(name)}}; }

}  // namespace blossom::protocol
