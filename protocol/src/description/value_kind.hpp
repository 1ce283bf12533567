#pragma once

#include <string_view>

#include <blossom/protocol/json.hpp>

namespace blossom::protocol {

/// The closed list of what values in JSON may be; `value_kind.cpp` has the JSON Schema of each.
enum class ValueKind {
    number,
    count,
    integer,
    boolean,
    flag,
    no,
    text,
    polynomial_text,
    list_text,
    null,
    any,
    point,
    interval,
    nested_points,
    sample,
    argument,
    point_argument,
    doubles,
    nearest_double,
    document,
    map,
};

/// Where a value stands. Numbers of a result are strings in lowest terms.
enum class Side { request, result };

/// What documents call a value of this kind, and several.
std::string_view text_of(ValueKind kind);
std::string_view plural_of(ValueKind kind);

/// The JSON Schema, which may refer to a definition; null where there is no such value on this side.
Json schema_of(ValueKind kind, Side side);

/// The definitions of the kinds of values, which their schemas refer to.
Json::Object value_definitions();

/// {"$ref": "#/$defs/NAME"}
Json reference_to(std::string_view name);

}  // namespace blossom::protocol
