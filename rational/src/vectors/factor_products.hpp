#pragma once

// Products of many linear factors of few bits, one block of factors per vector lane. This header contains
// only what the sources compiled for one instruction set may include: no inline functions, which the linker
// could choose for the whole program.

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
    std::int64_t last[most_blocks];     ///< coefficients of the last block again, contiguous
    std::uint64_t bounds[most_blocks];  ///< on the sum of the magnitudes of a block, below 2^51
    std::uint64_t denominators[most_blocks];
    std::size_t blocks;    ///< a power of two
    std::uint32_t primes;  ///< those of the denominators, see small_primes
};

/// The sets of odd primes of the numbers up to `greatest_known`, one bit per prime; all bits stand for
/// unknown.
struct Primes {
    const std::uint32_t* of;
    std::uint64_t greatest_known;  ///< one less than a power of two
};

/// The product of `factors` of three words each, constant, slope and denominator, none of them the least
/// 64-bit value. Returns false unless the number and the sizes of the factors fit in a product.
using Multiply = bool (*)(const void* factors, std::size_t count, const Primes& primes, Product& product);

bool avx512_multiply(const void* factors, std::size_t count, const Primes& primes, Product& product);

}  // namespace blossom::factor_products
