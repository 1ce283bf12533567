#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "batch.hpp"
#include "line_reader.hpp"
#include "protocol_names.hpp"

namespace blossom::cli {

/// Where the program reads and writes.
struct Streams {
    LineReader::Source input;
    Sink output;
    Sink errors;
    bool coloured_output = false;
    bool coloured_errors = false;
    bool shows_progress = false;  ///< errors go to a terminal, where a line can be written over
};

/// The standard streams. Output is coloured on a terminal, unless NO_COLOR is set or TERM is "dumb" or not
/// set.
Streams standard_streams();

/// The bytes of a file. Errors: std::system_error.
LineReader::Source file_source(const std::string& path);

/// Writes or replaces a file. The old file stays until the new one is complete, if
/// the folder is writable. Errors: std::system_error.
void write_file(const std::filesystem::path& path, std::string_view text);

/// All bytes of `source`. Errors: `limit_exceeded` beyond `longest` bytes.
std::string read_all(const LineReader::Source& source, std::size_t longest);

}  // namespace blossom::cli
