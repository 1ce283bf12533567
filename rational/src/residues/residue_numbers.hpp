#pragma once

// Residues of many large numbers.

#include <span>

#include "residue_system.hpp"
#include "small_fractions.hpp"

namespace blossom::residues {

/// Numerators over one denominator as they are reduced modulo many primes: by their digits, or as the
/// denominator times small fractions, where they are such and where that is faster.
class Numbers {
public:
    Numbers() = default;
    /// For so many groups of primes.
    Numbers(std::span<const Integer> numerators, const Integer& denominator, std::size_t groups);

    std::size_t size() const { return numerators_.size(); }
    void residues(const Moduli& moduli, ResidueVector* residues) const;

private:
    /// False if a prime of the group divides the bottom of a fraction.
    bool residues_of_fractions(const Moduli& moduli, ResidueVector* residues) const;

    std::span<const Integer> numerators_;
    Digits digits_;  ///< of the numerators; or of the tops, of the bottoms and of the denominator
    Digits bottoms_;
    Digits denominator_;
};

}  // namespace blossom::residues
