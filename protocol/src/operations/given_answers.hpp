#pragma once

#include <blossom/rational/limits.hpp>

#include <optional>
#include <string_view>
#include <vector>

#include <blossom/protocol/json.hpp>

/// What a command is given as JSON may be the --json output of another command.

namespace blossom::protocol {

/// Every function here refuses an answer that is an error, or that has no such thing, with a `UsageError`.

/// The maps in a value: a map, a list of them, or an answer with "map" or "maps". Rounded twins of an answer
/// are left out.
std::vector<Json> maps_in(const Json& given);

/// The document in a value, or in an answer of `export`.
Json document_in(const Json& given);

/// The computed numbers in a value, or in an answer: the members of its map, or its values, as doubles where
/// it has them.
/// Numbers without a double are exact.
Json computed_in(const Json& given, const Limits& limits);

/// If the text is an answer, its list for a field of this name; for "at" also nodes or coordinates.
std::optional<Json> list_in_answer(std::string_view text, std::string_view field, const Limits& limits);

}  // namespace blossom::protocol
