#pragma once

#include <blossom/worked/document.hpp>
#include <blossom/worked/notation.hpp>

#include <pugixml.hpp>

#include <initializer_list>
#include <string>
#include <utility>

#include "drawing/drawing.hpp"

namespace blossom::worked {

/// Appends an element with attributes.
pugi::xml_node append(pugi::xml_node parent, const char* element,
                      std::initializer_list<std::pair<const char*, std::string>> attributes);

/// <svg> of a size with a title that screen readers read, and a description if there is one.
pugi::xml_node append_svg(pugi::xml_node parent, Length width, Length height, const std::string& identifier,
                          const std::string& title, const std::string& description);

pugi::xml_node append_line(pugi::xml_node parent, const Segment& segment, const std::string& style);

/// Text at a place: `anchor` is start, middle or end of it, its middle line at y.
pugi::xml_node append_label(pugi::xml_node parent, Spot place, const char* anchor, const std::string& style,
                            const std::string& text);

/// Appends <svg> with the picture; `number` makes its identifiers unique on the page.
pugi::xml_node append_picture(pugi::xml_node parent, const Picture& picture, const Notation& notation,
                              std::size_t number);

/// Appends <svg> with the pyramid, levels from left to right.
pugi::xml_node append_pyramid(pugi::xml_node parent, const TrianglePyramid& pyramid, const Notation& notation,
                              std::size_t number);

/// The colours and line styles of both, light and dark.
std::string svg_style();

}  // namespace blossom::worked
