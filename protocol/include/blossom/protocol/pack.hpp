#pragma once

#include <blossom/rational/limits.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// Golden packs: cases with exact results, against which other programs test their arithmetic with doubles.

namespace blossom::protocol {

/// The families of cases: "evaluate", "blossom", "derivative", ...
std::vector<std::string_view> pack_families();

/// What to write. Equal packs have equal lines, on every machine; a pack with fewer cases is the beginning of
/// a longer one.
struct Pack {
    std::string family;
    std::uint64_t seed = 1;
    std::size_t cases = 100;
};

/// Gives each line of a pack, without its end, to `line`: a header, the cases, and a checksum.
///
/// Each case is a request of the protocol whose numbers are doubles, and its exact result with the nearest
/// doubles and hexadecimal floats. Cases in turn have ordinary numbers, sums that cancel, ratios of up to
/// 2^200, and for splines knots that almost coincide, and knots that repeat. docs/packs.md describes the
/// lines. Cost: that of the requests. Errors: `unknown_field` for another family; `limit_exceeded`.
void write_pack(const Pack& pack, const Limits& limits, const std::function<void(std::string_view)>& line);

}  // namespace blossom::protocol
