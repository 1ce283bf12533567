#pragma once

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>
#include "support/catch.hpp"
#include "support/failure.hpp"

#include "json/json_text.hpp"
#include "responses.hpp"

/// Functions that the tests of the protocol share.

namespace blossom::protocol {

/// The response to one line of a batch.
inline Json served(std::string_view line, const Limits& limits = {}) {
    return parse_json(answer(line, limits).text, Limits{});
}

/// The value at a pointer into the response, as JSON text; "" if there is none.
inline std::string served_at(std::string_view pointer, std::string_view line, const Limits& limits = {}) {
    const Json response = served(line, limits);
    const Json* place = at_pointer(response, pointer);
    return place ? to_text(*place) : "";
}

/// The result of a request without its braces, as JSON text; the whole response if it is refused.
inline std::string result_text(const std::string& request, const Limits& limits = {}) {
    const Json response = served("{" + request + "}", limits);
    const Json* found = response.find("result");
    return to_text(found ? *found : response);
}

/// The code and the place of the error, "wrong_kind /map"; the whole response if there is none.
inline std::string refusal_text(const std::string& request, const Limits& limits = {}) {
    const Json response = served("{" + request + "}", limits);
    const Json* error = response.find("error");
    if (!error) return to_text(response);
    return *error->find("code")->text() + " " + *error->find("at")->text();
}

}  // namespace blossom::protocol

using namespace blossom;
using namespace blossom::protocol;
using namespace blossom::testing;
