#include "shading.hpp"

#include <fmt/format.h>

#include <array>

namespace blossom::protocol {

namespace {

using Colour = std::array<std::size_t, 3>;

constexpr std::array<Colour, 6> surface_colours = {{{0x1a, 0x73, 0xe8},
                                                    {0xe8, 0x71, 0x0a},
                                                    {0x18, 0x80, 0x38},
                                                    {0x93, 0x34, 0xe6},
                                                    {0xd0, 0x18, 0x84},
                                                    {0x12, 0x9e, 0xaf}}};
constexpr std::size_t white = 255;

/// A mixture of a colour with the grey `other`; `hundredths` is the part of the colour.
std::string mixed(const Colour& colour, std::size_t hundredths, std::size_t other) {
    std::string text = "#";
    for (const std::size_t part : colour) {
        text += fmt::format("{:02x}", (part * hundredths + other * (100 - hundredths)) / 100);
    }
    return text;
}

const Colour& colour_of(std::size_t i) { return surface_colours[i % surface_colours.size()]; }

}  // namespace

std::string shade(std::size_t i, std::size_t tilt) {
    constexpr std::size_t least = 14;
    constexpr std::size_t greatest = 50;
    return mixed(colour_of(i), greatest - (greatest - least) * tilt / greatest_tilt, white);
}

std::string line_colour(std::size_t i) { return mixed(colour_of(i), 80, 0); }

}  // namespace blossom::protocol
