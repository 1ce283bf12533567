#pragma once

#include <string>
#include <string_view>

namespace blossom::worked {

/// A name as it is written.
struct Letter {
    std::string unicode;
    std::string latex;
};

/// "delta" as the Greek letter, "t" and signs such as "…" as themselves, a longer name as one word.
Letter letter(std::string_view name);

/// `text` with the characters that mean something to LaTeX escaped.
std::string latex_text(std::string_view text);

/// The number of columns that UTF-8 text takes in a terminal.
std::size_t columns(std::string_view text);

/// A sign such as "≤" or "↦" as LaTeX's mathematical mode writes it.
std::string latex_sign(std::string_view sign);

}  // namespace blossom::worked
