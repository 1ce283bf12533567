#pragma once

// Sums over products of linear factors by residues.

#include <blossom/rational/blossom_sums.hpp>

#include <mutex>
#include <vector>

#include "residues/residue_system.hpp"
#include "residues/residue_transforms.hpp"

namespace blossom {

/// Rows of numbers modulo the first groups of primes: the residues, or their `transform_numbers` if the group
/// has transforms for rows of this length.
struct ResidueRows {
    std::vector<residues::ResidueVector> vectors;
    std::vector<std::size_t> begins{0};  ///< the beginnings of the rows of each group, and the end
};

/// Keeps the residues of all rows for the next call.
class ResidueCache {
public:
    using Rows = std::shared_ptr<const ResidueRows>;

    /// The rows for `size` numbers per row; null if they would take more than `most_kept` bytes.
    Rows of(const RationalVector& numbers, std::size_t size, std::size_t groups) const;

    static constexpr std::size_t most_kept = std::size_t{64} << 20;  ///< bytes

private:
    mutable std::mutex mutex_;
    mutable Rows kept_;
};

/// Polynomials whose product is that of the linear factors.
struct FactorBlocks {
    residues::Digits coefficients;  ///< one polynomial after the other, lowest coefficients first
    std::vector<std::size_t> sizes;
    residues::TransformPlan plan;
    std::vector<std::size_t> leaves;  ///< the first polynomial of each leaf of the plan, and the end
};
FactorBlocks blocks_of(std::span<const WordFactor> factors);
FactorBlocks blocks_of(std::span<const IntegerFactor> factors);

/// The numerators of the sums, of at most `bits` bits, for `count` rows from `first_row` on. `numbers` holds
/// all rows; `cache` belongs to them, or is null if nothing is to be kept.
std::vector<Integer> residue_sums(const RationalVector& numbers, const ResidueCache* cache,
                                  const FactorBlocks& factors, std::size_t bits, std::size_t first_row,
                                  std::size_t count);

}  // namespace blossom
