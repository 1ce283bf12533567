#pragma once

// Small fractions from large numerators over one denominator.

#include <blossom/rational/integer.hpp>

#include <optional>
#include <span>
#include <vector>

namespace blossom {

/// Numbers denominator * tops[k] / bottoms[k], in lowest terms but for those of which both are large.
struct SmallFractions {
    std::vector<Integer> tops;
    std::vector<Integer> bottoms;
};

/// What numerators[k] / denominator are in lowest terms, where that has at most a quarter of the words of the
/// denominator for most k; nothing otherwise. The others stay as they are. Both sides of what is found are
/// multiplied out, so that it is right.
///
/// Cost for fractions of h words over a denominator of m: 2 h m + O(h^2) each.
std::optional<SmallFractions> small_fractions(std::span<const Integer> numerators,
                                              const Integer& denominator);

}  // namespace blossom
