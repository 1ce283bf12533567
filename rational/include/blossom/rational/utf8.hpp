#pragma once

#include <cstddef>
#include <string_view>

/// Characters of UTF-8 text.

namespace blossom {

/// Whether a byte continues a character, that is, is not its first byte.
constexpr bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// The number of bytes of the character at the front of `text`; 0 if `text` is empty or does not start with a
/// valid UTF-8 character.
std::size_t character_length(std::string_view text);

/// The number of characters of a UTF-8 text.
std::size_t count_characters(std::string_view text);

}  // namespace blossom
