#pragma once

#include <blossom/worked/document.hpp>

#include <string>

namespace blossom::worked {

/// Words with formulas between them, in LaTeX.
std::string latex_words(const Text& text, const Notation& notation);

}  // namespace blossom::worked
