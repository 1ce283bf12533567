#include <blossom/rational/written_marks.hpp>

#include <algorithm>
#include <iterator>

namespace blossom {

namespace {

constexpr bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

struct Spelling {
    std::string_view text;
    char meaning;
};

constexpr Spelling marks[] = {{"\u2212", '-'}, {"\u00B7", '*'}, {"\u22C5", '*'},
                              {"\u00D7", '*'}, {"\u2044", '/'}, {"\u2215", '/'}};

constexpr Spelling raised[] = {{"\u2070", '0'}, {"\u00B9", '1'}, {"\u00B2", '2'}, {"\u00B3", '3'},
                               {"\u2074", '4'}, {"\u2075", '5'}, {"\u2076", '6'}, {"\u2077", '7'},
                               {"\u2078", '8'}, {"\u2079", '9'}};

constexpr Spelling raised_signs[] = {{"\u207B", '-'}, {"\u207A", '+'}};

struct FractionSpelling {
    std::string_view text;
    int numerator;
    int denominator;
};

constexpr FractionSpelling fractions[] = {
    {"\u00BC", 1, 4},  {"\u00BD", 1, 2}, {"\u00BE", 3, 4}, {"\u2150", 1, 7}, {"\u2151", 1, 9},
    {"\u2152", 1, 10}, {"\u2153", 1, 3}, {"\u2154", 2, 3}, {"\u2155", 1, 5}, {"\u2156", 2, 5},
    {"\u2157", 3, 5},  {"\u2158", 4, 5}, {"\u2159", 1, 6}, {"\u215A", 5, 6}, {"\u215B", 1, 8},
    {"\u215C", 3, 8},  {"\u215D", 5, 8}, {"\u215E", 7, 8}};

/// The spelling at the front of `text`, or nullptr.
template <class Spellings>
auto spelling_at(std::string_view text, const Spellings& spellings) {
    const auto found = std::ranges::find_if(
        spellings, [&](const auto& spelling) { return text.starts_with(spelling.text); });
    return found == std::end(spellings) ? nullptr : found;
}

}  // namespace

WrittenMark rare_mark(std::string_view text) {
    if (text.starts_with("**")) return {'^', 2};
    if (const Spelling* mark = spelling_at(text, marks)) return {mark->meaning, mark->text.size()};
    return {text.front(), 1};
}

Superscript superscript(std::string_view text) {
    Superscript result;
    if (text.empty() || is_ascii(text.front())) return result;
    if (const Spelling* sign = spelling_at(text, raised_signs)) {
        if (!spelling_at(text.substr(sign->text.size()), raised)) return result;
        if (sign->meaning == '-') result.digits = "-";
        result.length = sign->text.size();
    }
    while (const Spelling* digit = spelling_at(text.substr(result.length), raised)) {
        result.digits += digit->meaning;
        result.length += digit->text.size();
    }
    return result;
}

VulgarFraction vulgar_fraction(std::string_view text) {
    if (text.empty() || is_ascii(text.front())) return {};
    const FractionSpelling* found = spelling_at(text, fractions);
    if (!found) return {};
    return {found->numerator, found->denominator, found->text.size()};
}

}  // namespace blossom
