#include <blossom/proofs/parser.hpp>
#include <blossom/worked/general_statement.hpp>

#include <array>
#include <cctype>
#include <optional>
#include <string_view>
#include <utility>

/// What the prover writes, "3t^2 - 1/2 x_1 != 0", read as formulas.

namespace blossom::worked {

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// The text with the sign of each product that is written as "3t" or "1/2 t".
std::string with_product_signs(std::string_view text) {
    std::string result;
    bool in_number = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool begins =
            i == 0 || (!is_digit(text[i - 1]) && !is_letter(text[i - 1]) && text[i - 1] != '_');
        in_number = is_digit(text[i]) && (in_number || begins);
        result += text[i];
        const bool ends = in_number && i + 1 < text.size() && !is_digit(text[i + 1]);
        if (!ends) continue;
        const std::size_t next = text.find_first_not_of(' ', i + 1);
        if (next != std::string_view::npos && is_letter(text[next])) result += '*';
    }
    return result;
}

/// The two sides of a relation and its sign in a text of the prover.
std::optional<std::pair<std::string, std::size_t>> relation_in(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, const char*>, 3> relations{
        {{" != ", "≠"}, {" == ", "="}, {" = ", "="}}};
    for (const auto& [written, sign] : relations) {
        const std::size_t at = text.find(written);
        if (at != std::string_view::npos) return std::pair(std::string(sign), at);
    }
    return std::nullopt;
}

}  // namespace

Formula formula_of_text(std::string_view text) {
    if (const auto found = relation_in(text)) {
        const auto& [sign, at] = *found;
        const std::size_t end = text.find(' ', at + 1) + 1;
        return relation(sign, {formula_of_text(text.substr(0, at)), formula_of_text(text.substr(end))});
    }
    const proofs::Document document = proofs::parse("claim " + with_product_signs(text) + " == 0");
    if (!document.errors.empty()) return words(std::string(text));
    const proofs::Block& block = document.blocks.front();
    return formula_of(block, block.statements.front().sides.front());
}

}  // namespace blossom::worked
