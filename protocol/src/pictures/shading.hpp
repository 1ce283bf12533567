#pragma once

#include <cstddef>
#include <string>

namespace blossom::protocol {

/// The greatest tilt of a face: 0 is a face parallel to the light, this one perpendicular to it.
inline constexpr std::size_t greatest_tilt = 12;

/// The fill of a face of surface number i.
std::string shade(std::size_t i, std::size_t tilt);
/// The colour of the lines on it.
std::string line_colour(std::size_t i);

}  // namespace blossom::protocol
