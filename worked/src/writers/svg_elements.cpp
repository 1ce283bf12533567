#include "svg.hpp"

namespace blossom::worked {

namespace {

/// From the middle line of a text to its base line.
constexpr Length half_letter = 48;

}  // namespace

pugi::xml_node append(pugi::xml_node parent, const char* element,
                      std::initializer_list<std::pair<const char*, std::string>> attributes) {
    pugi::xml_node node = parent.append_child(element);
    for (const auto& [name, value] : attributes) node.append_attribute(name) = value.c_str();
    return node;
}

pugi::xml_node append_svg(pugi::xml_node parent, Length width, Length height, const std::string& identifier,
                          const std::string& title, const std::string& description) {
    const std::string name = identifier + "-title";
    const std::string details = identifier + "-description";
    pugi::xml_node svg = append(parent, "svg",
                                {{"xmlns", "http://www.w3.org/2000/svg"},
                                 {"viewBox", "0 0 " + pixels(width) + " " + pixels(height)},
                                 {"width", pixels(width)},
                                 {"height", pixels(height)},
                                 {"role", "img"},
                                 {"aria-labelledby", description.empty() ? name : name + " " + details}});
    append(svg, "title", {{"id", name}}).text().set(title.c_str());
    if (!description.empty()) append(svg, "desc", {{"id", details}}).text().set(description.c_str());
    return svg;
}

pugi::xml_node append_line(pugi::xml_node parent, const Segment& segment, const std::string& style) {
    return append(parent, "line",
                  {{"x1", pixels(segment.begin.x)},
                   {"y1", pixels(segment.begin.y)},
                   {"x2", pixels(segment.end.x)},
                   {"y2", pixels(segment.end.y)},
                   {"class", style}});
}

pugi::xml_node append_label(pugi::xml_node parent, Spot place, const char* anchor, const std::string& style,
                            const std::string& text) {
    pugi::xml_node node = append(parent, "text",
                                 {{"x", pixels(place.x)},
                                  {"y", pixels(place.y + half_letter)},
                                  {"text-anchor", anchor},
                                  {"class", style}});
    node.text().set(text.c_str());
    return node;
}

}  // namespace blossom::worked
