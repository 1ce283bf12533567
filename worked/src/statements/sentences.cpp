#include "sentences.hpp"

#include <algorithm>

namespace blossom::worked {

void append_list(Text& text, const std::vector<Text>& entries) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (i > 0) text.append(std::string(i + 1 == entries.size() ? " and " : ", "));
        text.append(entries[i]);
    }
}

void append_list(Text& text, const std::vector<Formula>& formulas) {
    if (std::ranges::find(formulas, symbol("…")) != formulas.end()) return text.append(list_of(formulas));
    append_list(text, std::vector<Text>(formulas.begin(), formulas.end()));
}

}  // namespace blossom::worked
