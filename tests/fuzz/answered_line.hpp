#pragma once

#include <blossom/rational/limits.hpp>

#include <cstdint>
#include <span>

/// Aborts unless the response to the line is one line of valid JSON that says whether the request succeeded,
/// and not an internal error.
void check_answered(std::span<const std::uint8_t> line, const blossom::Limits& limits);
