#pragma once

#include <blossom/worked/document.hpp>
#include <blossom/worked/notation.hpp>

#include <pugixml.hpp>

#include <string>

namespace blossom::worked {

/// Appends <svg> with the picture; `number` makes its identifiers unique on the page.
pugi::xml_node append_picture(pugi::xml_node parent, const Picture& picture, const Notation& notation,
                              std::size_t number);

/// Appends <svg> with the pyramid, levels from left to right.
pugi::xml_node append_pyramid(pugi::xml_node parent, const TrianglePyramid& pyramid, const Notation& notation,
                              std::size_t number);

/// The colours and line styles of both, light and dark.
std::string svg_style();

}  // namespace blossom::worked
