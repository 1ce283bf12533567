#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <blossom/protocol/json.hpp>

/// Results as text for a person.

namespace blossom::protocol {

/// The style of a text, with or without emphasis.
class Style {
public:
    Style() = default;
    explicit Style(bool coloured) : coloured_(coloured) {}

    std::string bold(std::string_view text) const { return in("1", text); }
    std::string good(std::string_view text) const { return in("32", text); }
    std::string bad(std::string_view text) const { return in("31", text); }

private:
    std::string in(std::string_view code, std::string_view text) const;

    bool coloured_ = false;
};

/// "41/3", "(1, 1/2)", or with a rounded twin "41/3 ≈ 13.666666666666666".
std::string point_text(const Json& point, const Json* twin = nullptr);

/// Member `name` of `result`, as one point, with its rounded twin when there is one.
std::string member_text(const Json& result, std::string_view name);
/// The same for a member that is a list of points.
std::vector<std::string> member_texts(const Json& result, std::string_view name);

/// A parameter in parentheses, "(1/2)", "(1/2, 1)".
std::string parameter_text(const Json& parameter);

/// The arguments of a request: "1, 2, delta".
std::string arguments_text(const Json& arguments);

/// Rows of texts in columns, aligned on the right.
std::string table_text(const std::vector<std::vector<std::string>>& rows);

}  // namespace blossom::protocol
