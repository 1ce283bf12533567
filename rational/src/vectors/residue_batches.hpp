#pragma once

// Integers from their residues by the Chinese remainder theorem, eight numbers at a time, a number a lane.
// Only what the sources compiled for single instruction sets may include: nothing inline from elsewhere,
// which the linker could take for all.

#include "residue_lanes.hpp"

namespace blossom::residues {

/// With products M of primes p below 2^50 a number x is sum_p y_p (M / p) - q M, where y_p = x / (M / p)
/// modulo p. The integer q is sum_p y_p / p rounded, for |x| < M / 4.
struct BatchTables {
    static constexpr std::size_t digit_bits = 52;
    static constexpr std::size_t digits_at_once = 8;
    /// Sums of as many products of a digit, in two parts of 52 bits, fit in 63 bits.
    static constexpr std::size_t most_primes = 512;

    std::size_t primes;  ///< a multiple of 8
    std::size_t digits;  ///< of the product; in memory their number is a multiple of `digits_at_once`
    std::size_t words;   ///< of 64 bits that hold `digits`
    /// Digits d to d + digits_at_once of M / p, for all primes p, then the next digits for all primes.
    const std::uint64_t* cofactors;
    const std::uint64_t* product;  ///< the digits of M
    /// The integer part of 2^101 / p: y_p times it, over 2^52, is 2^49 y_p / p but for less than 1.25.
    const std::uint64_t* reciprocals;
};

/// Numbers i < 8 with y_p in numbers[g * stride + i] for the eight primes of group g, each below its prime,
/// in two's complement: words[w] has word w of all of them. `room` has room for `primes` residue vectors and
/// digits in memory, and two more.
using IntegersOfResidues = void (*)(const BatchTables& tables, const ResidueVector* numbers,
                                    std::size_t stride, ResidueVector* room, ResidueVector* words);

void avx512_integers_of_residues(const BatchTables& tables, const ResidueVector* numbers, std::size_t stride,
                                 ResidueVector* room, ResidueVector* words);

}  // namespace blossom::residues
