#pragma once

// Quotients of large integers in lowest terms, by factors of the denominator: with G = prod gcd(N, f_i) over
// factors f_i whose product is D, gcd(N, D) = gcd(N, G), and G is small if little cancels.

#include <blossom/rational/rational.hpp>

#include <cstdint>
#include <span>

namespace blossom {

/// sign * numerator / (prod words * prod longer) for a numerator in words, least significant first, and
/// positive factors. Cost: the remainders of the numerator by a tree of the factors, and one gcd per factor;
/// the gcds of words are computed many at a time.
Rational reduced_quotient(std::span<const std::uint64_t> numerator, bool negative,
                          std::span<const std::uint64_t> words, std::span<const Integer> longer);

}  // namespace blossom
