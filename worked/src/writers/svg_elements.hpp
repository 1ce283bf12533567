#pragma once

#include <pugixml.hpp>

#include <string>
#include <string_view>

#include "drawing/drawing.hpp"

namespace blossom::worked {

/// <svg> of a size with a title that screen readers read, and a description if there is one.
pugi::xml_node append_svg(pugi::xml_node parent, Length width, Length height, const std::string& identifier,
                          const std::string& title, const std::string& description);

pugi::xml_node append_line(pugi::xml_node parent, const Segment& segment, const char* style);

/// Text at a place: `anchor` is start, middle or end of it, its middle line at y.
pugi::xml_node append_label(pugi::xml_node parent, Spot place, const char* anchor, const char* style,
                            std::string_view text);

}  // namespace blossom::worked
