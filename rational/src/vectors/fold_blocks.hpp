#pragma once

// Sums over products of linear factors in digits of 52 bits, eight sums to a vector. Only what the sources
// compiled for single instruction sets may include: nothing inline from elsewhere, which the linker could
// take for all.

#include <cstddef>
#include <cstdint>

namespace blossom::fold_blocks {

inline constexpr std::size_t digit_bits = 52;
/// The most factors.
inline constexpr std::size_t most_factors = 128;
/// The most digits of a number; results have room for so many.
inline constexpr std::size_t most_digits = 16;
/// Digits of the same place of all numbers of a row lie side by side, so many from one place to the next:
/// those of most_factors + 1 numbers, and fifteen behind them, which are read but not used.
inline constexpr std::size_t most_stride = 144;

/// The coefficients of a product of linear factors, below 2^51 in magnitude, each `step` places after the one
/// before, one in the last block; and the digits that suffice for what is folded with them.
struct Block {
    const std::int64_t* coefficients;
    std::size_t step;
    std::size_t degree;
    std::size_t digits;
};

/// Numbers c_0, c_1, ... in two's complement of `digits` digits, `stride` apart.
struct Columns {
    const std::uint64_t* digits_of_all;
    std::size_t digits;
    std::size_t stride;
    std::size_t count;
};

/// Each block B turns the numbers c into sum_j B_j c_(i+j), fewer by its degree, until one is left, whose
/// digits these are, each with a sign and a carry for the next one: the sum is that of sum[d] 2^(52 d) modulo
/// 2^52 to the digits of the last block. The first block has no more digits than the numbers, and each
/// further one as many as the one before or one more.
using Fold = void (*)(const Columns& numbers, const Block* blocks, std::size_t block_count,
                      std::int64_t* sum);

void avx512_fold(const Columns& numbers, const Block* blocks, std::size_t block_count, std::int64_t* sum);

}  // namespace blossom::fold_blocks
