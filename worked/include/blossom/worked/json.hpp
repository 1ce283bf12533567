#pragma once

#include <blossom/rational/rational.hpp>

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace blossom {

/// A JSON value, for requests, responses and documents.
///
/// Numbers keep their text, so that integers of any size are exact and an `id` is returned
/// unchanged. An exact number of a result is a `Rational`; it is written as a string. Members keep their
/// order.
class Json {
public:
    struct Number {
        std::string text;
        friend bool operator==(const Number&, const Number&) = default;
    };
    using Array = std::vector<Json>;
    using Member = std::pair<std::string, Json>;
    struct NewMember;
    struct Object : std::vector<Member> {
        Object() = default;
        /// Moves the values; an initializer list would copy them.
        Object(std::initializer_list<NewMember> members);
    };

    Json() = default;
    Json(std::same_as<bool> auto value) : value_(value) {}              // NOLINT(google-explicit-constructor)
    Json(std::size_t value) : value_(Number{std::to_string(value)}) {}  // NOLINT(google-explicit-constructor)
    Json(Number value) : value_(std::move(value)) {}                    // NOLINT(google-explicit-constructor)
    Json(Rational value) : value_(std::move(value)) {}                  // NOLINT(google-explicit-constructor)
    Json(std::string value) : value_(std::move(value)) {}               // NOLINT(google-explicit-constructor)
    Json(std::string_view value)                                        // NOLINT(google-explicit-constructor)
        : value_(std::in_place_type<std::string>, value) {}
    Json(const char* value) : Json(std::string_view(value)) {}  // NOLINT(google-explicit-constructor)
    Json(Array value) : value_(std::move(value)) {}             // NOLINT(google-explicit-constructor)
    Json(Object value) : value_(std::move(value)) {}            // NOLINT(google-explicit-constructor)

    bool is_null() const { return std::holds_alternative<std::monostate>(value_); }
    /// The value of this alternative, or nullptr.
    const bool* boolean() const { return std::get_if<bool>(&value_); }
    const Number* number() const { return std::get_if<Number>(&value_); }
    const Rational* exact() const { return std::get_if<Rational>(&value_); }
    const std::string* text() const { return std::get_if<std::string>(&value_); }
    const Array* array() const { return std::get_if<Array>(&value_); }
    const Object* object() const { return std::get_if<Object>(&value_); }
    Array* array() { return std::get_if<Array>(&value_); }
    Object* object() { return std::get_if<Object>(&value_); }

    /// The member of an object, or nullptr if there is none or the value is not an object.
    const Json* find(std::string_view name) const;
    /// The member of an object, added as null if there is none; a null becomes an object.
    Json& operator[](std::string_view name);

    /// Becomes null.
    void clear() { value_.emplace<std::monostate>(); }

    friend bool operator==(const Json&, const Json&) = default;

private:
    std::variant<std::monostate, bool, Number, Rational, std::string, Array, Object> value_;
};

struct Json::NewMember {
    std::string name;
    mutable Json value;
};

inline Json::Object::Object(std::initializer_list<NewMember> members) {
    reserve(members.size());
    for (const NewMember& member : members) emplace_back(member.name, std::move(member.value));
}

/// The value as valid UTF-8: on one line, or with `indent` spaces per level and one line per element and
/// member.
std::string to_text(const Json& value, std::optional<std::size_t> indent = {});
/// On one line; what is written is freed at once, so that a large value and its text are not held together.
std::string to_text(Json&& value);

}  // namespace blossom
