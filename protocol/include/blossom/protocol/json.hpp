#pragma once

#include <blossom/rational/place.hpp>
#include <blossom/worked/json.hpp>

#include <string>
#include <string_view>

namespace blossom::protocol {

using blossom::Json;
using blossom::to_text;

/// "null", "a boolean", "a number", "a string", "an array" or "an object", for messages.
std::string_view type_name(const Json& value);

/// The value that a JSON Pointer leads to, or nullptr.
const Json* at_pointer(const Json& value, std::string_view pointer);

/// The value at a place, or nullptr.
const Json* at_place(const Json& value, const Place& place);

/// As much of a place as the value has.
Place present_part(const Json& value, const Place& place);

/// The JSON Pointer (RFC 6901) of a place; a parameter of the engine is the member of the same name.
std::string pointer_of(const Place& place);

}  // namespace blossom::protocol
