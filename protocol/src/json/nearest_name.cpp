#include "nearest_name.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace blossom::protocol {

namespace {

/// Levenshtein's distance, row by row.
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (const char letter : a) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (letter == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string suggestion(std::string_view written, std::span<const std::string_view> names) {
    constexpr std::size_t longest = 40;
    if (written.size() > longest) return "";
    std::string_view nearest;
    std::size_t least = longest;
    for (const std::string_view name : names) {
        const std::size_t changes = distance(written, name);
        if (changes < least && 3 * changes <= std::max<std::size_t>(name.size(), 3)) {
            nearest = name;
            least = changes;
        }
    }
    return nearest.empty() ? "" : " (did you mean \"" + std::string(nearest) + "\"?)";
}

}  // namespace blossom::protocol
