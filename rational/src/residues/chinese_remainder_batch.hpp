#pragma once

// Many integers at once from their residues, on processors with the vector instructions.

#include <blossom/rational/integer.hpp>

#include <optional>
#include <vector>

#include "residue_products.hpp"
#include "vectors/residue_batches.hpp"

namespace blossom::residues {

/// The Chinese remainder theorem for integers below a fourth of the product of the first groups of primes.
class ChineseRemainderBatch {
public:
    /// The least number of groups that suffices for integers of at most `bits` bits; nullopt if integers are
    /// faster to combine one by one.
    static std::optional<ChineseRemainderBatch> for_bits(std::size_t bits);

    explicit ChineseRemainderBatch(std::size_t groups);

    std::size_t groups() const { return factors_.size(); }

    /// Combines number k < count from residues[g * stride + k] for all groups g, and destroys the residues.
    /// The stride is a multiple of 8.
    std::vector<Integer> integers(ResidueVector* residues, std::size_t stride, std::size_t count) const;

private:
    BatchTables tables() const;

    std::vector<ResidueVector> factors_;  ///< 1 / (M / p), times the radix
    std::size_t digits_;
    std::vector<std::uint64_t> cofactors_;
    std::vector<std::uint64_t> product_;
    std::vector<std::uint64_t> reciprocals_;
};

}  // namespace blossom::residues
