#pragma once

// Sums over products of linear factors in digits of 52 bits, eight sums per vector. This header contains only
// what the sources compiled for one instruction set may include: no inline functions, which the linker could
// choose for the whole program.

#include <cstddef>
#include <cstdint>

namespace blossom::fold_blocks {

inline constexpr std::size_t digit_bits = 52;
/// The most factors.
inline constexpr std::size_t most_factors = 128;
/// The most digits of a number; results have room for them.
inline constexpr std::size_t most_digits = 16;
/// The digits with the same position of all numbers of a row are contiguous. This is the greatest distance
/// between two positions: most_factors + 1 numbers, and fifteen elements that are read but not used.
inline constexpr std::size_t most_stride = 144;

/// The coefficients of a product of linear factors, below 2^51 in magnitude, at a distance of `step` elements
/// (1 in the last block); and the number of digits that suffices for the folded numbers.
struct Block {
    const std::int64_t* coefficients;
    std::size_t step;
    std::size_t degree;
    std::size_t digits;
};

/// Numbers c_0, c_1, ... in two's complement of `digits` digits at a distance of `stride`.
struct Columns {
    const std::uint64_t* digits_of_all;
    std::size_t digits;
    std::size_t stride;
    std::size_t count;
};

/// Each block B replaces the numbers c by sum_j B_j c_(i+j), which are fewer by its degree, until one number
/// remains. Its digits are the result, each with a sign and a carry for the next one: the sum is that of
/// sum[d] 2^(52 d), modulo 2^52 to the power of the digits of the last block. The first block has no more
/// digits than the numbers, and each further block as many as the previous one or one more.
using Fold = void (*)(const Columns& numbers, const Block* blocks, std::size_t block_count,
                      std::int64_t* sum);

void avx512_fold(const Columns& numbers, const Block* blocks, std::size_t block_count, std::int64_t* sum);

}  // namespace blossom::fold_blocks
