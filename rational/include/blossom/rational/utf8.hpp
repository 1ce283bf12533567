#pragma once

#include <cstddef>
#include <string_view>

/// The characters of text in UTF-8.

namespace blossom {

/// Whether a byte is not the first of a character.
constexpr bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// The number of bytes of the character at the front of `text`; 0 if `text` is empty or does not start with a
/// character of UTF-8.
std::size_t character_length(std::string_view text);

/// The number of characters of a text of UTF-8.
std::size_t count_characters(std::string_view text);

}  // namespace blossom
