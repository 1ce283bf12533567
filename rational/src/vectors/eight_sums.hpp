#pragma once

// Sums over products of few linear factors for eight tuples of factors at once, in words of 64 bits. This
// header contains only what the sources compiled for one instruction set may include: no inline functions,
// which the linker could choose for the whole program.

#include <blossom/rational/word_line.hpp>

#include <cstddef>
#include <cstdint>

namespace blossom::eight_sums {

inline constexpr std::size_t lanes = 8;
/// The most factors of a tuple.
inline constexpr std::size_t most_factors = 8;

/// The same for sums that exceed a word.
inline constexpr std::size_t most_wide_factors = 16;

/// The most rows.
inline constexpr std::size_t most_rows = 8;

/// x * inverse modulo 2^64 is x / p if it is at most `most`; otherwise p does not divide x.
struct Divisor {
    std::uint64_t inverse;
    std::uint64_t most;
};

/// x * inverse modulo 2^104, in limbs of 52 bits: for x < 2^103 the upper limb is less than `beyond` if and
/// only if p divides x, and the product is then x / p.
struct WideDivisor {
    std::uint64_t inverse[2];
    std::uint64_t beyond;
};

/// The odd prime divisors of numbers: bit i of a set stands for divisors[i]; all bits together stand for
/// numbers that may have other primes.
struct Divisors {
    const std::uint32_t* of;       ///< the sets of 0, 1, ..., greatest_known
    std::uint64_t greatest_known;  ///< a number whose bits are all ones
    const Divisor* divisors;
    const WideDivisor* wide;
};

/// Rows of numbers over one denominator.
struct Rows {
    const std::int64_t* numbers;
    std::size_t rows;
    std::size_t bits;  ///< of the largest number and of the denominator
    std::uint64_t denominator;
    std::uint32_t divisors;  ///< of the denominator
};

/// One quotient per lane.
struct alignas(64) Quotients {
    std::int64_t numerators[lanes];
    std::int64_t denominators[lanes];
};

/// The sums of all rows in lowest terms for eight tuples of `count` <= most_factors factors. Returns false
/// and does nothing unless a bound shows that words suffice and all prime divisors of the denominators are
/// known.
///
/// Each tuple is `count` times eight words: for a factor m + u X the numbers u and m, each as numerator and
/// denominator, and each of these as a word and an address that is nonzero if the value is not a word. The
/// numbers of `line`, null if there is none, are signed numbers of 32 bits.
struct Operations {
    bool (*sums)(const Rows& rows, const void* const* tuples, std::size_t count, const WordLine* line,
                 const Divisors& divisors, Quotients* quotients);
    /// Sets eight consecutive numbers, each four words as above, to the quotients; returns false and does
    /// nothing if one of them holds an address.
    bool (*store)(const Quotients& quotients, void* numbers);
};

/// The same with numerators and denominators of two words, least significant first; numerators without sign.
struct alignas(64) WideQuotients {
    std::uint64_t numerators[2][lanes];
    std::uint64_t denominators[2][lanes];
    std::uint8_t negative;  ///< one bit per lane
};

/// As `Operations::sums` for `count` <= most_wide_factors, while 103 bits provably suffice.
struct WideOperations {
    bool (*sums)(const Rows& rows, const void* const* tuples, std::size_t count, const WordLine* line,
                 const Divisors& divisors, WideQuotients* quotients);
};

extern const Operations avx512_operations;
extern const WideOperations wide_avx512_operations;

}  // namespace blossom::eight_sums
