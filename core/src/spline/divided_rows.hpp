#pragma once

// Rows of integers over one denominator, divided entry by entry.

#include <blossom/rational/integer.hpp>

#include <span>
#include <vector>

namespace blossom {

/// Divides entry i of every row by divisors[i], which is not 0, and multiplies all by the least positive
/// integer that makes the quotients integers: what is returned, the factor of the denominator that the
/// entries need beyond the one they have.
///
/// Cost: a gcd and up to two divisions of an entry and its divisor.
Integer divide_entries(std::span<std::vector<Integer>> rows, std::span<const Integer> divisors);

}  // namespace blossom
