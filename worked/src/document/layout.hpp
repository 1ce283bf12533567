#pragma once

#include <blossom/worked/formula.hpp>
#include <blossom/worked/notation.hpp>

#include <string>
#include <vector>

namespace blossom::worked {

/// How a formula is drawn, with every sign and parenthesis in its place: what all printers have in common.
struct Layout {
    enum class Kind {
        number,      ///< digits
        identifier,  ///< one name
        words,
        relation,  ///< a sign with wide spaces; text
        binary,    ///< a sign with medium spaces; text
        sign,      ///< a minus sign in front, or a mark behind
        times,     ///< a product without sign
        apply,     ///< what stands between a name and its arguments
        comma,
        fraction,
        superscript,
        subscript,
        fenced,  ///< text: the two fences; parts: the inside
        under,   ///< parts[0] with parts[1] below, and parts[2] above if there is one
        cases,   ///< parts[0] if parts[1], otherwise parts[2]
        stack,   ///< parts[0] above parts[1] in parentheses
        row,
    };
    Kind kind = Kind::row;
    std::string text;
    std::vector<Layout> parts;
};

Layout layout_of(const Formula& formula, const Notation& notation);

/// The formula in pieces between which a line may end: before each relation, and before each sign of a sum
/// that is a side of it.
struct Piece {
    Layout layout;
    bool begins_side = false;  ///< begins with a relation
};
std::vector<Piece> pieces_of(const Formula& formula, const Notation& notation);

std::string text_of(const Layout& layout);
std::string latex_of(const Layout& layout);

}  // namespace blossom::worked
