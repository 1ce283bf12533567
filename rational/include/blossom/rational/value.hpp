#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <iosfwd>
#include <ranges>
#include <string>

namespace blossom {

/// What every value type of the library has: equality, a text and a hash. Streams print the text, `std::hash`
/// is the hash, and `blossom/rational/format.hpp` gives the text to `fmt::format` and `std::format`.
template <class T>
concept Value = std::equality_comparable<T> && requires(const T& value) {
    { to_string(value) } -> std::same_as<std::string>;
    { hash_value(value) } -> std::same_as<std::size_t>;
};

template <class Traits, Value T>
std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& stream, const T& value) {
    return stream << to_string(value);
}

/// One hash of several values, numbers of things, or ranges of these.
template <class... Parts>
std::size_t hash_of(const Parts&... parts) {
    constexpr std::size_t factor = 1'000'003;
    std::size_t hash = sizeof...(parts);
    const auto add = [&](const auto& add_part, const auto& part) -> void {
        using Element = std::remove_cvref_t<decltype(part)>;
        if constexpr (std::ranges::range<Element>) {
            hash = hash * factor + std::ranges::size(part);
            for (const auto& element : part) add_part(add_part, element);
        } else {
            hash = hash * factor + std::hash<Element>{}(part);
        }
    };
    (add(add, parts), ...);
    return hash;
}

}  // namespace blossom

template <blossom::Value T>
struct std::hash<T> {
    std::size_t operator()(const T& value) const { return hash_value(value); }
};
