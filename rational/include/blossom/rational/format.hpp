#pragma once

#include <blossom/rational/value.hpp>

#include <string_view>
#include <version>

#ifdef __cpp_lib_format
#include <format>
#endif
#if __has_include(<fmt/format.h>)
#include <fmt/format.h>
#endif

/// Values in `std::format`, where the standard library has it, and in `fmt::format`, where fmt is installed.
/// They are formatted as their texts, with the options for text.

#ifdef __cpp_lib_format
template <blossom::Value T>
struct std::formatter<T> : std::formatter<std::string_view> {
    auto format(const T& value, auto& context) const {
        return std::formatter<std::string_view>::format(to_string(value), context);
    }
};
#endif

#if __has_include(<fmt/format.h>)
template <blossom::Value T>
struct fmt::formatter<T> : fmt::formatter<std::string_view> {
    auto format(const T& value, auto& context) const {
        return fmt::formatter<std::string_view>::format(to_string(value), context);
    }
};
#endif
