#pragma once

#include <string>
#include <string_view>

#include <blossom/protocol/json.hpp>

namespace blossom::protocol {

/// A message with each of its numbers as the request has it, "0.1" for 1/10, where it occurs there. `exact`
/// is the request with exact numbers in the place of JSON numbers.
std::string with_typed_numbers(std::string_view message, const Json& request, const Json& exact);

}  // namespace blossom::protocol
