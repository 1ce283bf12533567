#pragma once

#include <string_view>
#include <vector>

#include <blossom/protocol/json.hpp>

namespace blossom::protocol {

/// The rounded numbers beside the exact ones.
enum class Rounding { none, binary64, hexadecimal };

/// "double" and "hexfloat".
std::vector<std::string_view> rounding_names();

/// The rounding that "numbers" asks for. Errors: `wrong_kind`.
Rounding read_rounding(const Json& value);

/// The suffix of the name of a rounded twin: "_double" or "_hex".
std::string_view rounding_suffix(Rounding rounding);

/// Whether a member of that name is a rounded twin of another.
bool is_rounded_twin(std::string_view name);

/// Adds beside every member of `result` that is an exact number or an array of them, of any depth, the same
/// shape correctly rounded: to JSON numbers that read back as the nearest double, or to C hexadecimal floats.
/// Errors: `overflow`, naming the place in the result; the field is "/numbers".
void add_rounded_numbers(Json& result, Rounding rounding);

}  // namespace blossom::protocol
