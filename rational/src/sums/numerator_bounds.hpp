#pragma once

// Bounds on the numerators of sums over products of linear factors, in integer arithmetic.

#include "prepared_rows.hpp"

namespace blossom {

/// Bounds in bits on the coefficients of the product and on the numerators of the sums: max |c_k| times the
/// product, over the factors, of the sum of the magnitudes of their coefficients.
struct Bounds {
    std::size_t product;
    std::size_t sum;
};
Bounds bounds(const BlossomSums::PreparedRows& rows, std::span<const WordFactor> factors);

/// A bound in bits on the numerators of the sums.
std::size_t sum_bits(const BlossomSums::PreparedRows& rows, std::span<const WordFactor> factors);
std::size_t sum_bits(const BlossomSums::PreparedRows& rows, std::span<const IntegerFactor> factors);

}  // namespace blossom
