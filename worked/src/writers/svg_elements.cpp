#include "svg_elements.hpp"

namespace blossom::worked {

namespace {

/// From the middle line of a text to its base line.
constexpr Length half_letter = 48;

}  // namespace

pugi::xml_node append_svg(pugi::xml_node parent, Length width, Length height, const std::string& identifier,
                          const std::string& title, const std::string& description) {
    pugi::xml_node svg = parent.append_child("svg");
    svg.append_attribute("xmlns") = "http://www.w3.org/2000/svg";
    svg.append_attribute("viewBox") = ("0 0 " + pixels(width) + " " + pixels(height)).c_str();
    svg.append_attribute("width") = pixels(width).c_str();
    svg.append_attribute("height") = pixels(height).c_str();
    svg.append_attribute("role") = "img";
    const std::string described =
        identifier + "-title" + (description.empty() ? "" : " " + identifier + "-description");
    svg.append_attribute("aria-labelledby") = described.c_str();
    pugi::xml_node name = svg.append_child("title");
    name.append_attribute("id") = (identifier + "-title").c_str();
    name.text().set(title.c_str());
    if (!description.empty()) {
        pugi::xml_node node = svg.append_child("desc");
        node.append_attribute("id") = (identifier + "-description").c_str();
        node.text().set(description.c_str());
    }
    return svg;
}

pugi::xml_node append_line(pugi::xml_node parent, const Segment& segment, const char* style) {
    pugi::xml_node line = parent.append_child("line");
    line.append_attribute("x1") = pixels(segment.begin.x).c_str();
    line.append_attribute("y1") = pixels(segment.begin.y).c_str();
    line.append_attribute("x2") = pixels(segment.end.x).c_str();
    line.append_attribute("y2") = pixels(segment.end.y).c_str();
    line.append_attribute("class") = style;
    return line;
}

pugi::xml_node append_label(pugi::xml_node parent, Spot place, const char* anchor, const char* style,
                            std::string_view text) {
    pugi::xml_node node = parent.append_child("text");
    node.append_attribute("x") = pixels(place.x).c_str();
    node.append_attribute("y") = pixels(place.y + half_letter).c_str();
    node.append_attribute("text-anchor") = anchor;
    node.append_attribute("class") = style;
    node.text().set(std::string(text).c_str());
    return node;
}

}  // namespace blossom::worked
