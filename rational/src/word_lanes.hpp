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

/// The odd prime divisors of numbers: bit i of a set stands for divisors[i], and all bits for numbers that
/// may have others.
struct Divisors {
    const std::uint32_t* of_odd;  ///< of 1, 3, 5, ..., greatest_known
    std::uint64_t greatest_known;
    const Divisor* divisors;
};

/// Rows of numbers over one denominator.
struct Rows {
    const std::int64_t* numbers;
    std::size_t rows;
    std::uint64_t greatest;  ///< magnitude
    std::uint64_t denominator;
    std::uint32_t divisors;  ///< of the denominator
};

/// A quotient a lane.
struct alignas(64) Quotients {
    std::int64_t numerators[lanes];
    std::int64_t denominators[lanes];
};

/// The sums of all rows for eight tuples of `count` <= most_factors factors, in lowest terms. Nothing, and
/// false, unless words suffice by a bound and all divisors of the denominators are known.
using Sums = bool (*)(const Rows& rows, const WordFactorOctet* factors, std::size_t count,
                      const Divisors& divisors, Quotients* sums);

#if defined(BLOSSOM_AVX512_WORDS)
bool avx512_sums(const Rows& rows, const WordFactorOctet* factors, std::size_t count,
                 const Divisors& divisors, Quotients* sums);
#endif

}  // namespace blossom::word_lanes
