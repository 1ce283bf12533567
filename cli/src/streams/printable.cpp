#include "printable.hpp"

#include <blossom/rational/utf8.hpp>

#include <algorithm>
#include <cstddef>

namespace blossom::cli {

namespace {

/// The bytes of a colour, ESC [ digits m, at the front of `text`; 0 if there is none.
std::size_t colour_length(std::string_view text) {
    if (!text.starts_with("\x1b[")) return 0;
    const std::size_t end = text.find_first_not_of("0123456789", 2);
    constexpr std::size_t longest = 5;
    return end < longest && text[end] == 'm' ? end + 1 : 0;
}

}  // namespace

std::string printable(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const auto first = static_cast<unsigned char>(text.front());
        const bool control = (first < 0x20 && first != '\n' && first != '\t') || first == 0x7F;
        std::size_t length = control ? colour_length(text) : character_length(text);
        if (text.substr(0, length) < "\u00A0" && length == 2)
            length = 0;  // controls that some terminals obey
        result += length == 0 ? std::string_view("?") : text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return result;
}

}  // namespace blossom::cli
