#pragma once

#include <string>

#include "protocol_names.hpp"
#include "responses.hpp"
#include "streams/streams.hpp"

namespace blossom::cli {

/// Writes the files of the gallery into a folder, which is made where there is none.
/// Errors: std::system_error for a file that cannot be written.
Outcome write_gallery(const std::string& folder, const Streams& streams);

}  // namespace blossom::cli
