#pragma once

#include <blossom/rational/error.hpp>
#include <blossom/rational/limits.hpp>

#include <optional>
#include <string_view>

#include <blossom/protocol/json.hpp>

namespace blossom::protocol {

/// What reading a JSON text gave: the value, or as much of it as was read before the error.
struct JsonReading {
    Json value;
    std::optional<Error> error;
};

/// Reads one JSON value that fills `text`, without recursion.
///
/// Errors: `syntax` for what is no JSON, invalid UTF-8 and a name that occurs twice in an object (at the
/// object); `limit_exceeded` for `nesting`, before anything nested deeper is stored.
JsonReading read_json(std::string_view text, const Limits& limits);

/// As `read_json`; an error is thrown.
Json parse_json(std::string_view text, const Limits& limits);

}  // namespace blossom::protocol
