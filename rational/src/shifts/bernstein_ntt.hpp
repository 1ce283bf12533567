#pragma once

// Operations on whole polynomials in residues. bernstein_kernel.hpp declares those on lines.

#include <blossom/rational/taylor_shift.hpp>

#include <optional>

namespace blossom::residues {

/// blossom::shifted_by_one for results of at most `bits` bits. Returns nullopt if the processor lacks the
/// vector instructions, or for too many coefficients or bits.
std::optional<std::vector<Integer>> shifted_by_one(std::span<const Integer> coefficients, std::size_t bits);

}  // namespace blossom::residues
