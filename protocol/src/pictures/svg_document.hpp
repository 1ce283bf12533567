#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace blossom::protocol {

/// `text` as character data or as an attribute value of XML 1.0; characters that XML does not have become
/// '?'.
std::string xml_escaped(std::string_view text);

/// An SVG picture, element by element, in the order of painting.
class SvgDocument {
public:
    using Attributes = std::initializer_list<std::pair<std::string_view, std::string>>;

    SvgDocument(std::size_t width, std::size_t height, std::string_view title);

    void add(std::string_view element, Attributes attributes, std::string_view text = "");
    /// The finished document.
    std::string text() const { return text_ + "</svg>\n"; }

private:
    std::string text_;
};

}  // namespace blossom::protocol
