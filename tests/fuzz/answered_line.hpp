#pragma once

#include <blossom/rational/limits.hpp>

#include <cstdint>
#include <span>

/// Aborts unless the response to the line is one line of valid JSON that says whether it succeeded, and no
/// error of the program.
void check_answered(std::span<const std::uint8_t> line, const blossom::Limits& limits);
