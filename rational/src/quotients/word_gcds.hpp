#pragma once

// Greatest common divisors of one long number and many words.

#include <cstdint>
#include <span>

namespace blossom {

/// common[i] = gcd(number, factors[i]) for a number > 0, least significant word first, and factors > 0. Cost:
/// one remainder per factor, and binary gcds, sixteen at a time if the processor has the vector instructions.
void gcds_with_words(std::span<const std::uint64_t> number, std::span<const std::uint64_t> factors,
                     std::uint64_t* common);

}  // namespace blossom
