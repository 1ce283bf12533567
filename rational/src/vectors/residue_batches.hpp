#pragma once

// Integers from their residues by the Chinese remainder theorem, eight numbers at once, one per lane. This
// header contains only what the sources compiled for one instruction set may include: no inline functions,
// which the linker could choose for the whole program.

#include "residue_lanes.hpp"

namespace blossom::residues {

/// For the product M of primes p below 2^50, a number x is sum_p y_p (M / p) - q M, where y_p = x / (M / p)
/// modulo p. For |x| < M / 4 the integer q is sum_p y_p / p rounded.
struct BatchTables {
    static constexpr std::size_t digit_bits = 52;
    static constexpr std::size_t digits_at_once = 8;
    /// The sum of this many products of a digit, in two parts of 52 bits, fits in 63 bits.
    static constexpr std::size_t most_primes = 512;

    std::size_t primes;  ///< a multiple of 8
    std::size_t digits;  ///< of the product; in memory their number is a multiple of `digits_at_once`
    std::size_t words;   ///< the 64-bit words that `digits` fill
    /// Digits d to d + digits_at_once of M / p for all primes p, then the next digits for all primes.
    const std::uint64_t* cofactors;
    const std::uint64_t* product;  ///< the digits of M
    /// The integer part of 2^101 / p: its product with y_p, divided by 2^52, differs from 2^49 y_p / p by
    /// less than 1.25.
    const std::uint64_t* reciprocals;
};

/// The numbers i < 8 whose y_p are in numbers[g * stride + i] for the eight primes of group g, each below its
/// prime, in two's complement: words[w] holds word w of all of them. `room` is scratch memory for `primes`
/// residue vectors, the digits in memory, and two more.
using IntegersOfResidues = void (*)(const BatchTables& tables, const ResidueVector* numbers,
                                    std::size_t stride, ResidueVector* room, ResidueVector* words);

void avx512_integers_of_residues(const BatchTables& tables, const ResidueVector* numbers, std::size_t stride,
                                 ResidueVector* room, ResidueVector* words);

}  // namespace blossom::residues
