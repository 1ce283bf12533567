#pragma once

#include <optional>

#include "maps/map.hpp"

namespace blossom::protocol {

/// A place in space, exact.
struct SpacePoint {
    Rational x;
    Rational y;
    Rational z;
};

/// A value of a map at some parameters: its coordinates, or its graph where it is scalar; none at infinity.
std::optional<SpacePoint> placed(Coordinates value, bool rational, const Coordinates& parameters);

/// The parameters of a point of the domain; without vertices those of the unit simplex.
Coordinates parameters_of(const Patch& patch, const PatchPoint& point);

/// Where a value of the map is, as a result gives it for a parameter of a request; none at infinity.
std::optional<SpacePoint> place_of_value(const Map& map, const Json& parameter, const Json& value,
                                         const Limits& limits);

}  // namespace blossom::protocol
