#pragma once

#include <blossom/rational/limits.hpp>

#include <optional>
#include <string_view>
#include <vector>

#include <blossom/protocol/json.hpp>

/// What the JSON numbers of a request stand for.

namespace blossom::protocol {

enum class Floats {
    decimal,   ///< the decimal that is written: 0.2 is 1/5
    binary64,  ///< the double nearest to it
};

/// "decimal" and "double".
std::vector<std::string_view> floats_names();
/// Errors: `wrong_kind`.
Floats read_floats(const Json& value);

/// The request with its JSON numbers as the exact values that field "floats" says; none without this field.
/// What other programs have computed or written, "computed" and "document", and the "id" stay.
/// Errors: those of `read_floats`; `overflow` beyond the range of doubles; `limit_exceeded` for `digits`.
std::optional<Json> with_exact_floats(const Json& request, const Limits& limits);

/// A value with its JSON numbers, and the texts that are numbers, as the decimals that are written.
Json with_decimals(const Json& value, const Limits& limits);

}  // namespace blossom::protocol
