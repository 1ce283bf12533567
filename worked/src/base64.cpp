#include "base64.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace blossom::worked {

std::string base64(std::string_view bytes) {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t present = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            group = group * 256 + (j < present ? static_cast<unsigned char>(bytes[i + j]) : 0U);
        }
        for (std::size_t j = 0; j < 4; ++j) {
            text += j <= present ? letters[(group >> (18 - 6 * j)) % 64] : '=';
        }
    }
    return text;
}

}  // namespace blossom::worked
