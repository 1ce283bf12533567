#pragma once

#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <span>
#include <string_view>

namespace blossom::protocol {

/// One limit of a request.
struct LimitEntry {
    std::string_view name;
    std::size_t Limits::* member;
    std::string_view help;
    std::size_t greatest;  ///< the greatest value that is accepted
};

std::span<const LimitEntry> limit_table();

}  // namespace blossom::protocol
