#pragma once

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

}  // namespace blossom::worked
