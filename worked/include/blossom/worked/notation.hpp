#pragma once

#include <blossom/worked/formula.hpp>

#include <string>

namespace blossom::worked {

/// The notation of a blossom value.
enum class BlossomStyle {
    parentheses,     ///< p(u, v, w), as Goldman and Ramshaw do
    brackets,        ///< p[u, v, w], as Farin and Fernandez-Jambrina do
    multiplicative,  ///< uvw, Goldman's short form
};

/// The notation of a whole document.
struct Notation {
    BlossomStyle style = BlossomStyle::parentheses;
    /// Whether equal arguments are written once, with their multiplicity: t^<3>, as in Farin.
    bool multiplicities = false;

    friend bool operator==(const Notation&, const Notation&) = default;
};

/// In Unicode, on one line: "p(1, 2, δ) = 8/3".
std::string to_text(const Formula& formula, const Notation& notation = {});

/// For LaTeX's mathematical mode, with nothing beyond its own commands and amsmath's.
std::string to_latex(const Formula& formula, const Notation& notation = {});

/// An element <math> as text. `display` selects the larger style of a formula on its own line.
std::string to_mathml(const Formula& formula, const Notation& notation = {}, bool display = false);

}  // namespace blossom::worked
