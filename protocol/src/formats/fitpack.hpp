#pragma once

#include "floats.hpp"
#include "formats.hpp"

/// The curves of FITPACK, as SciPy has them: knots t, coefficients c and degree k.

namespace blossom::protocol {

/// A list [t, c, k], an object {"t", "c", "k"}, or the text that Python prints for either. c has a number or
/// a point for each of the m = len(t) - k - 1 basis functions, or as FITPACK has it a list for each
/// coordinate; it may be padded with k + 1 zeros to the length of t.
std::vector<Map> read_fitpack(const Json& document, Floats floats, const Limits& limits);

/// [t, c, k] with points for the basis functions.
Json write_fitpack(const std::vector<Map>& splines);

}  // namespace blossom::protocol
