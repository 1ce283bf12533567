#pragma once

#include <blossom/rational/limits.hpp>

#include <functional>
#include <string_view>

#include "line_reader.hpp"
#include "protocol_names.hpp"
#include "responses.hpp"

namespace blossom::cli {

/// Writes one response with its line end, at once; false when nobody takes it any more.
using Sink = std::function<bool(std::string_view line)>;

/// Serves requests line by line, in order, until the lines or the sink end. Blank lines are skipped.
///
/// With one job each response is written before the next line is waited for. With more, `jobs` threads
/// answer; a response is written as soon as it and all before it are there, also while the next line is
/// waited for. At most 4 `jobs` lines are held.
Outcome serve_batch(const LineReader::Source& source, const Sink& sink, const Limits& limits,
                    std::size_t jobs);

}  // namespace blossom::cli
