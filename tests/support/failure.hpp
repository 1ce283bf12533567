#pragma once

#include <blossom/rational/error.hpp>

#include <optional>
#include <utility>

namespace blossom::testing {

/// The error that `action` throws, if any.
template <class Action>
std::optional<Error> failure(Action&& action) {
    try {
        std::forward<Action>(action)();
    } catch (const Error& error) {
        return error;
    }
    return std::nullopt;
}

/// Only the code of this error.
template <class Action>
std::optional<ErrorCode> failure_code(Action&& action) {
    const std::optional<Error> error = failure(std::forward<Action>(action));
    return error ? std::optional(error->code()) : std::nullopt;
}

}  // namespace blossom::testing
