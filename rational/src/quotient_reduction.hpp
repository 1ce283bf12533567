#pragma once

// Quotients of large integers in lowest terms, by way of factors of the denominator: with
// G = prod gcd(N, f_i) over any factors f_i of D, gcd(N, D) = gcd(N, G), and G is small when little cancels.

#include <blossom/rational/rational.hpp>

#include <cstdint>
#include <span>

namespace blossom {

/// numerator / prod factors, all factors positive. Cost: the remainders of the numerator by a tree of the
/// factors, and one gcd a factor.
Rational reduced_quotient(const Integer& numerator, std::span<const Integer> factors);
/// The same for a numerator in words, least significant first, and its sign.
Rational reduced_quotient(std::span<const std::uint64_t> numerator, bool negative,
                          std::span<const Integer> factors);

}  // namespace blossom
