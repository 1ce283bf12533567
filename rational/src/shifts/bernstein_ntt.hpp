#pragma once

// Whole polynomials in residues; what substitutes lines is in a header of its own.

#include <blossom/rational/taylor_shift.hpp>

#include <optional>

namespace blossom::residues {

/// blossom::shifted_by_one for results of at most `bits` bits. Nothing where the processor has no vectors for
/// it, or there are too many coefficients or bits.
std::optional<std::vector<Integer>> shifted_by_one(std::span<const Integer> coefficients, std::size_t bits);

}  // namespace blossom::residues
