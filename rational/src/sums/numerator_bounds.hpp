#pragma once

// Bounds on the numerators of sums over products of linear factors, in integers throughout.

#include "prepared_rows.hpp"

namespace blossom {

/// Bounds in bits on the coefficients of the product and on the numerators of the sums, max |c_k| times the
/// product of what the coefficients of each factor sum to.
struct Bounds {
    std::size_t product;
    std::size_t sum;
};
Bounds bounds(const BlossomSums::PreparedRows& rows, std::span<const WordFactor> factors);

/// A bound in bits on the numerators of the sums.
std::size_t sum_bits(const BlossomSums::PreparedRows& rows, std::span<const WordFactor> factors);
std::size_t sum_bits(const BlossomSums::PreparedRows& rows, std::span<const IntegerFactor> factors);

/// The same, at the cost of a look at each number: for t = 1/8, 1 and 8, with constants v_i and slopes u_i,
///
///     |e_k| <= t^-k prod (|v_i| + |u_i| t),
///
/// so that outer coefficients, where numbers divided by binomials are large, are known to be small.
std::size_t closer_sum_bits(const BlossomSums::PreparedRows& rows, std::span<const WordFactor> factors);
std::size_t closer_sum_bits(const BlossomSums::PreparedRows& rows, std::span<const IntegerFactor> factors);

}  // namespace blossom
