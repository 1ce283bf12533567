#pragma once

#include <blossom/rational/error.hpp>

#include <string>

#include "limit_table.hpp"
#include "protocol_names.hpp"

/// The flags that set the limits.

namespace blossom::cli {

/// "--max-" and the name, with '-' for '_'; "--timeout".
std::string flag_of(const LimitEntry& limit);

/// The flag that raises the limit which the error names; "" if it names none.
std::string flag_of(const Error& error);

/// The error with this flag behind its message: "... (--max-degree)".
Error with_flag(const Error& error);

/// Adds it to the members of an error in a response, as "flag".
void add_flag(const Error& error, Json::Object& members);

}  // namespace blossom::cli
