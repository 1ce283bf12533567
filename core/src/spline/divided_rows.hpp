#pragma once

// Rows of integers over one denominator, divided entry by entry.

#include <blossom/rational/integer.hpp>

#include <span>
#include <vector>

namespace blossom {

/// Divides entry i of every row by divisors[i], which is not 0, and multiplies all entries by the least
/// positive integer that makes the quotients integers. Returns this integer, by which the common denominator
/// grows.
///
/// Cost: a gcd and up to two divisions per entry.
Integer divide_entries(std::span<std::vector<Integer>> rows, std::span<const Integer> divisors);

}  // namespace blossom
