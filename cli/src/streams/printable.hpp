#pragma once

#include <string>
#include <string_view>

namespace blossom::cli {

/// `text` made safe for a terminal: bytes that are not UTF-8, and control characters except line ends, tabs
/// and the colours of this program, become '?'.
std::string printable(std::string_view text);

}  // namespace blossom::cli
