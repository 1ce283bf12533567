#pragma once

// Residues of many large numbers.

#include <span>

#include "residue_system.hpp"
#include "small_fractions.hpp"

namespace blossom::residues {

/// Numerators over one denominator, prepared for reduction modulo many primes: as digits, or as the
/// denominator times small fractions if they are such and if that is faster.
class Numbers {
public:
    Numbers() = default;
    /// Prepares for this many groups of primes.
    Numbers(std::span<const Integer> numerators, const Integer& denominator, std::size_t groups);

    std::size_t size() const { return numerators_.size(); }
    void residues(const Moduli& moduli, ResidueVector* residues) const;

private:
    /// Returns false if a prime of the group divides the denominator of a fraction.
    bool residues_of_fractions(const Moduli& moduli, ResidueVector* residues) const;

    std::span<const Integer> numerators_;
    /// Those of the numerators; or, for fractions, of their tops and bottoms and of the common denominator.
    Digits digits_;
    Digits bottoms_;
    Digits denominator_;
};

}  // namespace blossom::residues
