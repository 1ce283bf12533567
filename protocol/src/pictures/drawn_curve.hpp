#pragma once

#include <blossom/core/maps/point_array.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "maps/map.hpp"

namespace blossom::protocol {

/// A place in the plane of the picture, exact.
struct PlanePoint {
    Rational x;
    Rational y;
};

/// A place with a text beside it.
struct Mark {
    PlanePoint place;
    std::string label;
};

/// What is painted of one curve.
struct DrawnCurve {
    std::vector<std::vector<PlanePoint>> lines;    ///< the curve, broken where it jumps or has no point
    std::vector<std::vector<PlanePoint>> polygon;  ///< its control points, broken at a weight of zero
    std::vector<Mark> knots;                       ///< the places of its knots
};

/// The curve in the plane: its first two coordinates, or its graph where it has only one. `interval` is where
/// a curve without an interval of its own is painted, by default [0, 1]. Cost: at most about 1000 values, at
/// least 8 a segment. Errors: `wrong_kind` for a map that is no curve.
DrawnCurve drawn(const Map& map, const std::optional<Interval>& interval, const Limits& limits);

/// P(t) in the same plane; none where there is no such point.
std::optional<PlanePoint> place_of(const Json& value, const Rational& t, const PointForm& form);

/// The interval on which the curve is given, or none for a polynomial in any form.
std::optional<Interval> given_interval(const Map& map);

}  // namespace blossom::protocol
