#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// The marks of arithmetic as people write and print them.

namespace blossom {

/// A mark at the front of a text: the ASCII character with the same meaning, and the length in bytes.
struct WrittenMark {
    char meaning = '\0';
    std::size_t length = 0;
};

/// The mark at the front of `text`: '-' also for U+2212, '*' for the middle dot, the dot operator and the
/// multiplication sign, '^' for "**", '/' for the fraction and the division slash. Any other byte means
/// itself; of an empty text the meaning is 0. `rare_mark` is for marks that are no single byte.
WrittenMark rare_mark(std::string_view text);
inline WrittenMark written_mark(std::string_view text) {
    if (text.empty()) return {};
    const char c = text.front();
    const bool is_common = static_cast<unsigned char>(c) < 0x80 && c != '*';
    return is_common ? WrittenMark{c, 1} : rare_mark(text);
}

/// An exponent of superscript digits: "⁻¹²" is "-12".
struct Superscript {
    std::string digits;      ///< in ASCII, with the sign; "" where there is none
    std::size_t length = 0;  ///< in bytes
};

/// The superscript at the front of `text`.
Superscript superscript(std::string_view text);

/// A fraction that is one character, such as "½".
struct VulgarFraction {
    int numerator = 0;
    int denominator = 1;
    std::size_t length = 0;  ///< in bytes; 0 where there is none
};

/// The fraction at the front of `text`.
VulgarFraction vulgar_fraction(std::string_view text);

}  // namespace blossom
