#pragma once

#include <span>
#include <string>

#include "protocol_names.hpp"
#include "streams/streams.hpp"

namespace blossom::cli {

/// Runs the program with these arguments, without its name, and returns the exit status.
Outcome run(std::span<const std::string> arguments, const Streams& streams);

}  // namespace blossom::cli
