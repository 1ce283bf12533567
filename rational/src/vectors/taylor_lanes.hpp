#pragma once

// Multiplication of polynomials by powers of X + 1 on digits in vector lanes. Only what the sources compiled
// for single instruction sets may include: nothing inline from elsewhere, which the linker could take for
// all.

#include <cstddef>
#include <cstdint>

namespace blossom::taylor_lanes {

/// A number is sum_i d_i 2^(48 i), where the digits d_i are signed and have room to grow: sums of digits are
/// taken without carries, and the carries are moved up only now and then.
inline constexpr unsigned digit_bits = 48;
/// Additions of two numbers in a row until carries have to move: digits from 0 to 2^48 + 2^15 become at most
/// 2^14 times as large.
inline constexpr std::size_t levels = 14;

/// What a level of instruction sets offers; all give the same numbers.
struct Operations {
    /// Digits in a vector. Digits i of all coefficients with the same i / lanes lie together, as a plane.
    std::size_t lanes;
    /// One plane of the entries 0 to count - 1, an even number, of polynomials that are multiplied by X + 1
    /// `levels` times: previous[i] is the entry left of them before multiplication i, and becomes their last
    /// one. `carries` come from the plane below and are replaced by those for the plane above; the greatest
    /// digit of the top plane keeps its carry.
    void (*multiply)(std::int64_t* entries, std::size_t count, std::int64_t* previous, std::int64_t* carries,
                     bool top);
};

extern const Operations portable_operations;
extern const Operations avx512_operations;

}  // namespace blossom::taylor_lanes
