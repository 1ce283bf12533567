#pragma once

#include <blossom/worked/document.hpp>
#include <blossom/worked/notation.hpp>

#include <string>

namespace blossom::worked {

/// The picture as a tikzpicture, with the places of labels that SVG has.
std::string tikz_picture(const Picture& picture, const Notation& notation);

/// The pyramid as a tikzpicture, levels from left to right.
std::string tikz_pyramid(const TrianglePyramid& pyramid, const Notation& notation);

/// The colours and styles of both, for a preamble.
std::string tikz_styles();

}  // namespace blossom::worked
