#pragma once

// Small fractions that are given as large numerators over one denominator.

#include <blossom/rational/integer.hpp>

#include <optional>
#include <span>
#include <vector>

namespace blossom {

/// Numbers denominator * tops[k] / bottoms[k]; the fractions are in lowest terms except those that are large.
struct SmallFractions {
    std::vector<Integer> tops;
    std::vector<Integer> bottoms;
};

/// The fractions numerators[k] / denominator in lowest terms, if for most k these have at most a quarter of
/// the words of the denominator; nullopt otherwise. The other fractions are not reduced. Each fraction found
/// is verified by cross-multiplication.
///
/// Cost for fractions of h words over a denominator of m words: 2 h m + O(h^2) each.
std::optional<SmallFractions> small_fractions(std::span<const Integer> numerators,
                                              const Integer& denominator);

}  // namespace blossom
