#pragma once

#include <string>
#include <vector>

#include "protocol_names.hpp"

/// How statements stand on a command line.

namespace blossom::cli {

/// The maps of --degree as lines of the language. Errors: `UsageError`.
std::string map_lines(const std::vector<std::string>& degrees);

/// What -e is given as a text: the word "claim" may be left out.
std::string statement_text(const std::string& claim);

}  // namespace blossom::cli
