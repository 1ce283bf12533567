#pragma once

// Sums over products of linear factors by residues.

#include <blossom/rational/linear_factor_sums.hpp>

#include <mutex>
#include <vector>

#include "residue_system.hpp"

namespace blossom {

/// The numbers of all rows modulo the first groups of primes, kept for the next call.
class ResidueCache {
public:
    using Residues = std::shared_ptr<const std::vector<residues::Octet>>;

    /// Group after group, each with all numbers in their order; nothing if they would take more than
    /// `most_kept`.
    Residues of(std::span<const Integer> numbers, std::size_t groups) const;

    static constexpr std::size_t most_kept = std::size_t{64} << 20;  ///< bytes

private:
    mutable std::mutex mutex_;
    mutable Residues kept_;
};

/// Polynomials whose product is that of linear factors.
struct FactorBlocks {
    residues::Digits coefficients;  ///< one polynomial after the other, lowest coefficients first
    std::vector<std::size_t> sizes;
};
FactorBlocks blocks_of(std::span<const WordFactor> factors);
FactorBlocks blocks_of(std::span<const IntegerFactor> factors);

/// The numerators of the sums for `count` rows from `first_row` on, which have at most `bits` bits.
/// `numbers` are those of all rows; `cache` belongs to them, or is null where nothing is to be kept.
std::vector<Integer> residue_sums(std::span<const Integer> numbers, const ResidueCache* cache,
                                  const FactorBlocks& factors, std::size_t bits, std::size_t first_row,
                                  std::size_t count);

}  // namespace blossom
