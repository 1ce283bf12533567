#pragma once

#include <blossom/worked/picture.hpp>

#include <optional>
#include <string>

#include "maps/map.hpp"

namespace blossom::protocol {

/// The width of all pictures in pixels.
inline constexpr std::size_t picture_width = 544;
/// With more points or curves, names are left out.
inline constexpr std::size_t most_names = 16;

/// Draws the curve in the plane: its first two coordinates, or its graph where it has only one, with its
/// control polygon and, unless it is what was before, its knots. `interval` is where a curve without an
/// interval of its own is drawn, by default [0, 1]. Cost: at most about 1000 values, at least 8 a segment.
/// Errors: `wrong_kind` for a map that is no curve.
void draw_curve(worked::Picture& picture, const Map& map, const std::optional<Interval>& interval,
                worked::Role role, const std::string& name, const Limits& limits);

}  // namespace blossom::protocol
