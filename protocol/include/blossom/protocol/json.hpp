#pragma once

#include <blossom/rational/place.hpp>
#include <blossom/rational/rational.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace blossom::protocol {

/// A JSON value: what requests and responses are made of.
///
/// Numbers keep the text they were written with, so that integers of any size are exact and an `id` is echoed
/// as it came. An exact number of a result is a `Rational`; it is written as a string. Members keep their
/// order.
class Json {
public:
    struct Number {
        std::string text;
        friend bool operator==(const Number&, const Number&) = default;
    };
    using Array = std::vector<Json>;
    using Member = std::pair<std::string, Json>;
    using Object = std::vector<Member>;

    Json() = default;
    Json(std::same_as<bool> auto value) : value_(value) {}              // NOLINT(google-explicit-constructor)
    Json(std::size_t value) : value_(Number{std::to_string(value)}) {}  // NOLINT(google-explicit-constructor)
    Json(Number value) : value_(std::move(value)) {}                    // NOLINT(google-explicit-constructor)
    Json(Rational value) : value_(std::move(value)) {}                  // NOLINT(google-explicit-constructor)
    Json(std::string value) : value_(std::move(value)) {}               // NOLINT(google-explicit-constructor)
    Json(std::string_view value) : value_(std::string(value)) {}        // NOLINT(google-explicit-constructor)
    Json(const char* value) : value_(std::string(value)) {}             // NOLINT(google-explicit-constructor)
    Json(Array value) : value_(std::move(value)) {}                     // NOLINT(google-explicit-constructor)
    Json(Object value) : value_(std::move(value)) {}                    // NOLINT(google-explicit-constructor)

    bool is_null() const { return std::holds_alternative<std::monostate>(value_); }
    /// The alternative asked for, or nullptr.
    const bool* boolean() const { return std::get_if<bool>(&value_); }
    const Number* number() const { return std::get_if<Number>(&value_); }
    const Rational* exact() const { return std::get_if<Rational>(&value_); }
    const std::string* text() const { return std::get_if<std::string>(&value_); }
    const Array* array() const { return std::get_if<Array>(&value_); }
    const Object* object() const { return std::get_if<Object>(&value_); }
    Array* array() { return std::get_if<Array>(&value_); }
    Object* object() { return std::get_if<Object>(&value_); }

    /// The member of an object, or nullptr when there is none, or this is no object.
    const Json* find(std::string_view name) const;
    /// The member of an object, made (null) when there is none; a null becomes an object.
    Json& operator[](std::string_view name);

    friend bool operator==(const Json&, const Json&) = default;

private:
    std::variant<std::monostate, bool, Number, Rational, std::string, Array, Object> value_;
};

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

/// On one line, as valid UTF-8.
std::string to_text(const Json& value);

}  // namespace blossom::protocol
