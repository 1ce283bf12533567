#pragma once

// Points and lists as text for messages.

#include <blossom/core/maps/point_array.hpp>

#include <string>

namespace blossom {

/// The items separated by ", ".
template <class Items, class Text>
std::string listed(const Items& items, const Text& text) {
    std::string result;
    for (const auto& item : items) result += (result.empty() ? "" : ", ") + text(item);
    return result;
}

/// "(1, 1/2)", or a single number without parentheses.
inline std::string bracketed(const Coordinates& point) {
    if (point.size() == 1) return to_string(point.front());
    return "(" + listed(point, [](const Rational& coordinate) { return to_string(coordinate); }) + ")";
}

}  // namespace blossom
