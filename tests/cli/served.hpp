#pragma once

#include <string>
#include <string_view>

#include "answer.hpp"
#include "json_text.hpp"

/// What the tests of the protocol have in common.

namespace blossom::cli {

/// The response to one line of a batch.
inline Json served(std::string_view line, const Limits& limits = {}) {
    return parse_json(serve_line(line, limits).response, Limits{});
}

/// The value at a place of the response, as JSON text; "" when there is none.
inline std::string served_at(std::string_view pointer, std::string_view line, const Limits& limits = {}) {
    const Json response = served(line, limits);
    const Json* place = at_pointer(response, pointer);
    return place ? to_text(*place) : "";
}

}  // namespace blossom::cli
