#pragma once

#include <blossom/worked/notation.hpp>
#include <blossom/worked/picture.hpp>

#include <optional>
#include <string>
#include <vector>

#include "label_placement.hpp"

namespace blossom::worked {

/// The nearest integer.
Integer rounded(const Rational& value);

/// The height of a line of labels.
constexpr Length label_height = 180;

/// The width that `text` takes at most in the fonts of labels, of normal weight or bold.
Length text_width(std::string_view text, bool bold = false);

/// A picture on paper, labels placed: what SVG and TikZ have in common.
struct Drawing {
    struct Path {
        std::vector<Spot> spots;
        bool cubic = false;
        Role role = Role::construction;
        bool is_curve = false;
    };
    struct Face {
        std::vector<Spot> spots;
        const PictureFace& face;
    };
    struct Words {
        Spot spot;
        const PictureWords& words;
    };
    /// A piece of line with the name of what is drawn so.
    struct Key {
        Segment line;
        const PictureCurve& curve;
    };
    struct Label {
        Box box;
        std::vector<Formula> names;  ///< of the points in this dot; an equation for those of one place
        std::optional<Segment> leader;
    };
    struct Dot {
        Spot spot;
        Role role = Role::construction;
    };
    struct Tick {
        Segment across;  ///< from the axis over the paper
        std::string text;
        bool horizontal = true;  ///< on the axis of x
    };

    Length width = 0;
    Length height = 0;
    std::vector<Path> paths;
    std::vector<Face> faces;
    std::vector<Words> words;
    std::vector<Key> legend;
    std::vector<Dot> dots;
    std::vector<Label> labels;  ///< of each dot; those without names have no place
    std::vector<Segment> axes;
    std::vector<Tick> ticks;
};

Drawing drawn(const Picture& picture, const Notation& notation);

/// The names of one label in one line: "p(0, 0, 1) = p(1, 1, 1), p(0, 1, 1)".
Formula label_formula(const Drawing::Label& label);

/// Tenths of a pixel as pixels: 123 is "12.3".
std::string pixels(Length length);

}  // namespace blossom::worked
