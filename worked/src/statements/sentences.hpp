#pragma once

#include <blossom/worked/document.hpp>

#include <string>
#include <vector>

namespace blossom::worked {

/// Appends "x", "x and y", "x, y and z".
void append_list(Text& text, const std::vector<Text>& entries);
/// The same; a run t_1, ..., t_n among the formulas makes one formula of all.
void append_list(Text& text, const std::vector<Formula>& formulas);

}  // namespace blossom::worked
