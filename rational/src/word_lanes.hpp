#pragma once

// Sums over products of few linear factors for eight tuples of factors at a time, in words of 64 bits. Only
// what the sources compiled for single instruction sets may include: nothing inline from elsewhere, which the
// linker could take for all.

#include <blossom/rational/word_factor_octet.hpp>

#include <cstddef>
#include <cstdint>

namespace blossom::word_lanes {

inline constexpr std::size_t lanes = 8;
/// The most factors of a tuple.
inline constexpr std::size_t most_factors = 8;

/// The most rows.
inline constexpr std::size_t most_rows = 8;

/// x * inverse modulo 2^64 is x / p if that is at most `most`, and otherwise p does not divide x.
struct Divisor {
    std::uint64_t inverse;
    std::uint64_t most;
};

/// Rows of numbers over one denominator, `count` + 1 numbers each.
struct Rows {
    const std::int64_t* numbers;
    std::size_t rows;
    std::uint64_t greatest;  ///< magnitude
    std::uint64_t denominator;
};

/// A quotient a lane.
struct alignas(64) Quotients {
    std::int64_t numerators[lanes];
    std::int64_t denominators[lanes];
};

/// The sums of all rows for eight tuples of `count` <= most_factors factors, divided by the powers of two and
/// of the odd divisors that numerators and denominators have in common. Nothing, and false, unless words
/// suffice by a bound.
using Sums = bool (*)(const Rows& rows, const WordFactorOctet* factors, std::size_t count,
                      const Divisor* divisors, std::size_t divisor_count, Quotients* sums);

#if defined(BLOSSOM_AVX512_WORDS)
bool avx512_sums(const Rows& rows, const WordFactorOctet* factors, std::size_t count, const Divisor* divisors,
                 std::size_t divisor_count, Quotients* sums);
#endif

}  // namespace blossom::word_lanes
