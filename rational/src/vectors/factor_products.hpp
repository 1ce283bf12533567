#pragma once

// Products of many linear factors of few bits, a block of factors to a vector lane. Only what the sources
// compiled for single instruction sets may include: nothing inline from elsewhere, which the linker could
// take for all.

#include <cstddef>
#include <cstdint>

namespace blossom::factor_products {

inline constexpr std::size_t most_blocks = 8;
/// The most factors of a block.
inline constexpr std::size_t most_degree = 7;
static_assert(most_degree < most_blocks);
inline constexpr std::size_t least_factors = 5;
inline constexpr std::size_t most_factors = most_blocks * most_degree;

/// Block b is the product of the factors b, b + blocks, b + 2 blocks, ...
struct alignas(64) Product {
    std::int64_t coefficients[most_degree + 1][most_blocks];  ///< of X^j in block b, below 2^51 in magnitude
    std::int64_t last[most_blocks];     ///< coefficients of the last block once more, one behind the other
    std::uint64_t bounds[most_blocks];  ///< on the sum of the magnitudes of a block, below 2^51
    std::uint64_t denominators[most_blocks];
    std::size_t blocks;    ///< a power of two
    std::uint32_t primes;  ///< those of the denominators, see small_primes
};

/// Which odd primes a number up to `greatest_known` has, a bit for each of some; all bits for what is not
/// known.
struct Primes {
    const std::uint32_t* of;
    std::uint64_t greatest_known;  ///< one less than a power of two
};

/// The product of `factors` of three words, constant, slope and denominator, none the least value of 64 bits.
/// False unless the factors are as many and as small as a product has room for.
using Multiply = bool (*)(const void* factors, std::size_t count, const Primes& primes, Product& product);

bool avx512_multiply(const void* factors, std::size_t count, const Primes& primes, Product& product);

}  // namespace blossom::factor_products
