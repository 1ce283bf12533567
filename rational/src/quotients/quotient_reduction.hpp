#pragma once

// Quotients of large integers in lowest terms, by way of factors of the denominator: with
// G = prod gcd(N, f_i) over any factors f_i of D, gcd(N, D) = gcd(N, G), and G is small when little cancels.

#include <blossom/rational/rational.hpp>

#include <cstdint>
#include <span>

namespace blossom {

/// sign * numerator / (prod words * prod longer), where the numerator is in words, least significant first,
/// and all factors are positive. Cost: the remainders of the numerator by a tree of the factors, and one gcd
/// a factor, those of words many at a time.
Rational reduced_quotient(std::span<const std::uint64_t> numerator, bool negative,
                          std::span<const std::uint64_t> words, std::span<const Integer> longer);

}  // namespace blossom
