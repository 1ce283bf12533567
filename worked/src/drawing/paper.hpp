#pragma once

#include <blossom/worked/picture.hpp>

#include <vector>

#include "drawing.hpp"

namespace blossom::worked {

/// The nearest integer.
Integer rounded(const Rational& value);

/// How the places of a picture lie on paper: an exact affine map, rounded at the end.
class Paper {
public:
    explicit Paper(const Picture& picture);

    Length width() const { return width_; }
    Length height() const { return height_; }
    Spot spot(const Place& place) const;
    std::vector<Spot> spots(const std::vector<Place>& places) const;
    /// Where labels may stand.
    Box room() const;
    /// The two axes, if there are any.
    std::vector<Segment> axes() const;
    /// The numbers on the axes, at multiples of 1, 2 or 5 times a power of ten, with lines across the paper.
    std::vector<Drawing::Tick> ticks() const;

private:
    /// One direction: world = least + (paper - begin) / scale.
    struct Axis {
        Rational least;
        Rational greatest;
        Rational scale;
        Length begin = 0;

        Length length() const;
        Length at(const Rational& value) const;
        /// At both ends, so that it becomes `length` long if it is shorter.
        void widen(Length length);
        /// Multiples of a round number, at least `apart` from each other.
        std::vector<Rational> marks(Length apart) const;
    };

    bool axes_;
    Axis x_;
    Axis y_;
    Length width_ = 0;
    Length height_ = 0;
};

}  // namespace blossom::worked
