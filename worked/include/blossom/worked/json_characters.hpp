#pragma once

#include <array>
#include <cstddef>

namespace blossom {

/// Whether a character stands for itself in a string of JSON, and is one byte.
inline bool is_plain_in_json(char c) {
    static constexpr std::array<bool, 256> plain = [] {
        std::array<bool, 256> bytes{};
        for (std::size_t byte = 0x20; byte < 0x80; ++byte) bytes[byte] = byte != '"' && byte != '\\';
        return bytes;
    }();
    return plain[static_cast<unsigned char>(c)];
}

}  // namespace blossom
