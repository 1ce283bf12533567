#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include <blossom/protocol/json.hpp>

/// Lists in brackets, as JSON, Python and numpy print them.

namespace blossom::protocol {

/// How often something is repeated, where a text is such a count.
std::optional<std::size_t> repetitions(std::string_view text);

/// Whether a text is a list in brackets.
bool is_bracketed(std::string_view text);

/// The list, with its numbers as texts; several in a row are the elements of one.
/// Errors: `syntax`, with the place in the text.
Json bracketed_list(std::string_view text);

}  // namespace blossom::protocol
