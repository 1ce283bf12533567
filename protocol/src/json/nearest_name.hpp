#pragma once

#include <span>
#include <string>
#include <string_view>

namespace blossom::protocol {

/// " (did you mean "degree"?)" with the name that takes the fewest insertions, deletions and replacements of
/// a letter, when that is at most a third of its letters; otherwise "".
std::string suggestion(std::string_view written, std::span<const std::string_view> names);

}  // namespace blossom::protocol
