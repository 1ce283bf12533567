#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "value_kind.hpp"

namespace blossom::protocol {

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

/// "a, b or c".
std::string listed(const std::vector<std::string>& parts);

}  // namespace blossom::protocol
