#pragma once

#include <blossom/rational/limits.hpp>

#include <string>
#include <string_view>
#include <vector>

#include "operations/operation.hpp"
#include "protocol_names.hpp"
#include "streams/streams.hpp"

namespace blossom::cli {

/// One option of a command with its values.
struct GivenOption {
    const Option* option;
    std::vector<std::string> values;
};

/// A command as it was typed.
struct Command {
    const Operation& operation;
    std::vector<GivenOption> options;  ///< in the order of the table of the operation
    std::string numbers;               ///< the value of --numbers, or ""
    std::string floats;                ///< the value of --floats, or ""
    bool as_json;
    std::string picture;  ///< the file that --svg names, or ""
    std::string mesh;     ///< the file that --obj names, or ""
    Limits limits;
};

/// Builds the request, answers it and prints the result, or the error with its place.
/// Errors: `UsageError`.
Outcome run_command(const Command& command, const Streams& streams);

/// "error: ..." with the place in the request and the option that wrote it, or with a caret below the column
/// of a text.
std::string readable_error(const Error& error, const Json& request, const Command& command,
                           const Style& style);

}  // namespace blossom::cli
