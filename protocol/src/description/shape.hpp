#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <blossom/protocol/json.hpp>

/// How fields of requests and members of results are described.

namespace blossom::protocol {

/// The closed list of what values in JSON may be; `shape.cpp` has the JSON Schema of each.
enum class ValueKind {
    number,
    count,
    integer,
    boolean,
    flag,
    no,
    text,
    polynomial_text,
    null,
    any,
    point,
    interval,
    nested_points,
    sample,
    argument,
    point_argument,
    doubles,
    document,
    map,
};

/// Where a value stands. Numbers of a result are strings in lowest terms.
enum class Side { request, result };

class Shape;
struct Field;
struct Members;

/// What a value in JSON may be.
class Shape {
public:
    Shape(ValueKind kind) : value_(kind) {}  // NOLINT(google-explicit-constructor)

    static Shape words(std::vector<std::string_view> words);
    static Shape words(std::span<const std::string_view> words) {
        return Shape::words(std::vector(words.begin(), words.end()));
    }
    static Shape list(Shape element, std::size_t least = 0, std::size_t most = SIZE_MAX);
    /// A list of two values.
    static Shape pair(Shape first, Shape second);
    static Shape one_of(std::vector<Shape> alternatives);
    static Shape object(Members members);
    /// An object with members of any names.
    static Shape names(Shape member);
    /// A request of one of these operations.
    static Shape request_of(std::vector<std::string_view> operations);

    /// A value of either shape.
    static Shape united(const Shape& first, const Shape& second);

    /// The alternatives of a word; none for another shape.
    std::vector<std::string_view> alternatives() const;
    /// In words: "list of numbers". Each alternative of a word stands between two `quote`.
    std::string text(std::string_view quote = "\"") const;
    /// The JSON Schema, null where there is no such value on this side. The kinds of values are referred to
    /// as definitions.
    Json schema(Side side) const;
    /// Whether a result has rounded numbers beside a member of this shape.
    bool has_numbers() const;

private:
    struct Words {
        std::vector<std::string_view> words;
    };
    struct List {
        std::shared_ptr<const Shape> element;
        std::size_t least;
        std::size_t most;
    };
    struct Pair {
        std::shared_ptr<const Shape> first;
        std::shared_ptr<const Shape> second;
    };
    struct OneOf {
        std::vector<Shape> alternatives;
    };
    struct Names {
        std::shared_ptr<const Shape> member;
    };
    struct RequestOf {
        std::vector<std::string_view> operations;
    };
    using Object = std::shared_ptr<const Members>;
    using Value = std::variant<ValueKind, Words, List, Pair, OneOf, Object, Names, RequestOf>;

    explicit Shape(Value value) : value_(std::move(value)) {}
    std::string plural(std::string_view quote) const;

    Value value_;
};

enum class Presence {
    required,
    optional,
    defaulted,  ///< may be left out of a request, and stands in every result
};

/// A field of a request or of a map, or a member of a result.
struct Field {
    std::string_view name;
    Shape shape;
    Presence presence;
    std::string documentation;
};

inline Field required(std::string_view name, Shape shape, std::string documentation) {
    return {name, std::move(shape), Presence::required, std::move(documentation)};
}
inline Field optional(std::string_view name, Shape shape, std::string documentation) {
    return {name, std::move(shape), Presence::optional, std::move(documentation)};
}
inline Field defaulted(std::string_view name, Shape shape, std::string documentation) {
    return {name, std::move(shape), Presence::defaulted, std::move(documentation)};
}

using FieldList = std::vector<Field>;

/// Several sets of fields of which an object has one.
using Choice = std::vector<FieldList>;

/// The members of an object.
struct Members {
    FieldList fields;
    std::vector<Choice> choices = {};
    bool some = false;  ///< at least one is there, where all are optional
};

/// All fields, each name once, with every shape that it has in one of the choices. Those that may be left out
/// are last.
FieldList all_fields(const Members& members);
/// When a field must be there: "yes", "no", or what it stands together with.
std::string presence_text(const Members& members, std::string_view name);

/// The JSON Schema of an object with these members after those in `first`, which are required; null where no
/// result has such an object.
Json object_schema(const Members& members, Side side, const Json::Object& first = {});

/// The definitions of the kinds of values, which their schemas refer to.
Json::Object value_definitions();

/// {"$ref": "#/$defs/NAME"}
Json reference_to(std::string_view name);

}  // namespace blossom::protocol
