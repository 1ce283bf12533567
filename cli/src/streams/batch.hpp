#pragma once

#include <blossom/rational/limits.hpp>

#include <functional>
#include <string_view>

#include "line_reader.hpp"
#include "protocol_names.hpp"
#include "responses.hpp"

namespace blossom::cli {

/// Writes responses with their line ends, at once; false when nobody takes them any more.
using Sink = std::function<bool(std::string_view line)>;

/// Serves requests line by line, in order, until the lines or the sink end. Blank lines are skipped.
///
/// Lines that have arrived together form parts, of one line at first and of more while responses are short.
/// With one job each response is written before the next line is waited for. With more, `jobs` threads
/// answer; the responses of a part are written as soon as they and all before them are there, also while the
/// next line is waited for. At most 4 `jobs` parts are held.
Outcome serve_batch(const LineReader::Source& source, const Sink& sink, const Limits& limits,
                    std::size_t jobs);

}  // namespace blossom::cli
