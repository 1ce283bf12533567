#pragma once

// Sums over products of linear factors by residues.

#include <blossom/rational/blossom_sums.hpp>

#include <mutex>
#include <vector>

#include "residues/residue_system.hpp"
#include "residues/residue_transforms.hpp"

namespace blossom {

/// Rows of numbers modulo the first groups of primes: the residues themselves, or `transform_numbers` of them
/// where the group has transforms for rows of their length.
struct ResidueRows {
    std::vector<residues::ResidueVector> vectors;
    std::vector<std::size_t> begins{0};  ///< of the rows of each group, and the end
};

/// Keeps those of all rows for the next call.
class ResidueCache {
public:
    using Rows = std::shared_ptr<const ResidueRows>;

    /// For rows of `size` numbers; nothing if they would take more than `most_kept`.
    Rows of(const RationalVector& numbers, std::size_t size, std::size_t groups) const;

    static constexpr std::size_t most_kept = std::size_t{64} << 20;  ///< bytes

private:
    mutable std::mutex mutex_;
    mutable Rows kept_;
};

/// Polynomials whose product is that of linear factors.
struct FactorBlocks {
    residues::Digits coefficients;  ///< one polynomial after the other, lowest coefficients first
    std::vector<std::size_t> sizes;
    residues::TransformPlan plan;
    std::vector<std::size_t> leaves;  ///< the first polynomial of each leaf of the plan, and the end
};
FactorBlocks blocks_of(std::span<const WordFactor> factors);
FactorBlocks blocks_of(std::span<const IntegerFactor> factors);

/// The numerators of the sums for `count` rows from `first_row` on, which have at most `bits` bits.
/// `numbers` are those of all rows; `cache` belongs to them, or is null where nothing is to be kept.
std::vector<Integer> residue_sums(const RationalVector& numbers, const ResidueCache* cache,
                                  const FactorBlocks& factors, std::size_t bits, std::size_t first_row,
                                  std::size_t count);

}  // namespace blossom
