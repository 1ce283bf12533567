#pragma once

#include <string_view>
#include <vector>

#include "floats.hpp"
#include "maps/map.hpp"

namespace blossom::protocol {

/// Whether a text may be the data of an SVG path: it begins with M or m.
bool is_svg_path(std::string_view text);

/// The curves of an SVG path, M L H V C S Q T A Z, absolute and relative: segment i is a Bezier curve over
/// [i, i + 1]. A closing Z is a line, unless the path is closed already.
///
/// An arc is rational of degree 2, in parts of at most a quarter: (a, p, b) with p on both tangents and
/// weights 1, c, 1 for c = cos(angle / 2), or 1, c^2, c^2 where only c^2 is rational. Its centre is the
/// middle of the chord plus s times the chord turned by a quarter, s^2 = (1 - l) / l, where l is the square
/// of half the chord in units of the radii.
///
/// Errors, with their place in the text: `syntax`; `wrong_kind` for an arc whose centre or axes are not
/// rational; `limit_exceeded`.
/// Source: Scalable Vector Graphics 2, sections 9.3 and B.2.
std::vector<Map> svg_path_curves(std::string_view text, Floats floats, const Limits& limits);

}  // namespace blossom::protocol
