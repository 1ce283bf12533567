#pragma once

#include <blossom/worked/picture.hpp>

#include <vector>

#include "drawing.hpp"

namespace blossom::worked {

/// The nearest integer.
Integer rounded(const Rational& value);

/// Points on cubic arcs by de Casteljau's algorithm, exact places or, rounded, spots: fine enough to find how
/// far a curve goes and what covers what.
template <class Point>
std::vector<Point> flattened(const std::vector<Point>& points) {
    using Number = decltype(Point::x);
    constexpr std::int64_t pieces = 24;
    std::vector<Point> all{points.front()};
    for (std::size_t arc = 0; arc + 3 < points.size(); arc += 3) {
        for (std::int64_t k = 1; k <= pieces; ++k) {
            const auto value = [&](auto member) {
                const Number v(k);
                const Number u(pieces - k);
                const Number sum = u * u * u * points[arc].*member + 3 * u * u * v * points[arc + 1].*member +
                                   3 * u * v * v * points[arc + 2].*member +
                                   v * v * v * points[arc + 3].*member;
                return Number(sum / Number(pieces * pieces * pieces));
            };
            all.push_back({value(&Point::x), value(&Point::y)});
        }
    }
    return all;
}

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
