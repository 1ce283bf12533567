#include "members.hpp"

#include <algorithm>
#include <iterator>

namespace blossom::protocol {

namespace {

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
    const auto requires_field = [](const FieldList& fields, std::string_view one) {
        const Field* field = find_in(fields, one);
        return field && is_required(*field, Side::request);
    };
    if (find_in(members.fields, name)) return requires_field(members.fields, name) ? "yes" : "no";
    for (const Choice& choice : members.choices) {
        FieldList beside;  // the fields required where this one is
        bool everywhere = true;
        for (const FieldList& fields : choice) {
            if (!requires_field(fields, name)) {
                everywhere = false;
                continue;
            }
            std::ranges::copy_if(fields, std::back_inserter(beside), [&](const Field& field) {
                return field.name != name && requires_field(fields, field.name);
            });
        }
        const bool anywhere = std::ranges::any_of(
            choice, [&](const FieldList& fields) { return requires_field(fields, name); });
        if (anywhere && everywhere) return "yes";
        if (!anywhere) continue;
        std::vector<std::string> instead;
        for (const FieldList& fields : choice) {
            if (find_in(fields, name)) continue;
            const auto sign = std::ranges::find_if(fields, [&](const Field& field) {
                return requires_field(fields, field.name) && !find_in(beside, field.name);
            });
            if (sign == fields.end()) return "no";
            const std::string text = "`" + std::string(sign->name) + "`";
            if (std::ranges::find(instead, text) == instead.end()) instead.push_back(text);
        }
        if (!instead.empty()) return "or " + listed(instead);
        return beside.empty() ? "no" : "with `" + std::string(beside.front().name) + "`";
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

}  // namespace blossom::protocol
