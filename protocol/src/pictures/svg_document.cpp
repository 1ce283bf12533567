#include "svg_document.hpp"

#include <fmt/format.h>

namespace blossom::protocol {

std::string xml_escaped(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            default: {
                const auto byte = static_cast<unsigned char>(c);
                const bool control = byte < 0x20 && c != '\t' && c != '\n' && c != '\r';
                escaped += control ? '?' : c;
            }
        }
    }
    return escaped;
}

SvgDocument::SvgDocument(std::size_t width, std::size_t height, std::string_view title)
    : text_(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
                        "viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" font-size=\"12\">\n"
                        "<title>{2}</title>\n",
                        width, height, xml_escaped(title))) {}

void SvgDocument::add(std::string_view element, Attributes attributes, std::string_view text) {
    text_ += fmt::format("<{}", element);
    for (const auto& [name, value] : attributes) text_ += fmt::format(" {}=\"{}\"", name, xml_escaped(value));
    text_ += text.empty() ? "/>\n" : fmt::format(">{}</{}>\n", xml_escaped(text), element);
}

}  // namespace blossom::protocol
