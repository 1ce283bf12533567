#pragma once

// Sums over products of few linear factors for eight tuples of factors at a time, in words of 64 bits. Only
// what the sources compiled for single instruction sets may include: nothing inline from elsewhere, which the
// linker could take for all.

#include <blossom/rational/word_line.hpp>

#include <cstddef>
#include <cstdint>

namespace blossom::eight_sums {

inline constexpr std::size_t lanes = 8;
/// The most factors of a tuple.
inline constexpr std::size_t most_factors = 8;

/// The same for sums of more than a word.
inline constexpr std::size_t most_wide_factors = 16;

/// The most rows.
inline constexpr std::size_t most_rows = 8;

/// x * inverse modulo 2^64 is x / p if that is at most `most`, and otherwise p does not divide x.
struct Divisor {
    std::uint64_t inverse;
    std::uint64_t most;
};

/// x * inverse modulo 2^104, in limbs of 52 bits: for x < 2^103 the upper limb is less than `beyond` exactly
/// if p divides x, and the product is then x / p.
struct WideDivisor {
    std::uint64_t inverse[2];
    std::uint64_t beyond;
};

/// The odd prime divisors of numbers: bit i of a set stands for divisors[i], and all bits for numbers that
/// may have others.
struct Divisors {
    const std::uint32_t* of;       ///< of 0, 1, ..., greatest_known
    std::uint64_t greatest_known;  ///< all ones
    const Divisor* divisors;
    const WideDivisor* wide;
};

/// Rows of numbers over one denominator.
struct Rows {
    const std::int64_t* numbers;
    std::size_t rows;
    std::size_t bits;  ///< of the greatest number and of the denominator
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
///
/// Each tuple is `count` times eight words, those of the numbers u and m of a factor m + u X, each a
/// numerator and a denominator, each a word and an address that is not 0 where there is no word. The numbers
/// of `line`, null if there is none, have 32 bits with their signs.
struct Operations {
    bool (*sums)(const Rows& rows, const void* const* tuples, std::size_t count, const WordLine* line,
                 const Divisors& divisors, Quotients* quotients);
    /// Sets eight numbers one behind the other, each four words as above, to the quotients; nothing, and
    /// false, if one of them holds an address.
    bool (*store)(const Quotients& quotients, void* numbers);
};

/// The same of two words, least significant first, without the signs of the numerators.
struct alignas(64) WideQuotients {
    std::uint64_t numerators[2][lanes];
    std::uint64_t denominators[2][lanes];
    std::uint8_t negative;  ///< one bit per lane
};

/// As `Operations::sums` for `count` <= most_wide_factors, as long as 103 bits provably suffice.
struct WideOperations {
    bool (*sums)(const Rows& rows, const void* const* tuples, std::size_t count, const WordLine* line,
                 const Divisors& divisors, WideQuotients* quotients);
};

extern const Operations avx512_operations;
extern const WideOperations wide_avx512_operations;

}  // namespace blossom::eight_sums
