#pragma once

// Multiplication of polynomials by powers of X + 1 on digits in vector lanes. This header contains only what
// the sources compiled for one instruction set may include: no inline functions, which the linker could
// choose for the whole program.

#include <cstddef>
#include <cstdint>

namespace blossom::taylor_lanes {

/// A number is sum_i d_i 2^(48 i), where the signed digits d_i have room to grow: digits are added without
/// carries, which are propagated only now and then.
inline constexpr unsigned digit_bits = 48;
/// The number of additions between two propagations of carries: digits from 0 to 2^48 + 2^15 grow by a factor
/// of at most 2^14.
inline constexpr std::size_t levels = 14;

/// The operations of a level of vector instructions; all levels give the same numbers.
struct Operations {
    /// The digits per vector. A plane consists of the digits i of all coefficients with the same i / lanes;
    /// it is contiguous.
    std::size_t lanes;
    /// Multiplies one plane of the entries 0 to count - 1, an even number, of a polynomial by X + 1 `levels`
    /// times. previous[i] is the entry to their left before multiplication i, and is replaced by their last
    /// entry. `carries` come from the plane below and are replaced by those for the plane above; the highest
    /// digit of the top plane keeps its carry.
    void (*multiply)(std::int64_t* entries, std::size_t count, std::int64_t* previous, std::int64_t* carries,
                     bool top);
};

extern const Operations portable_operations;
extern const Operations avx512_operations;

}  // namespace blossom::taylor_lanes
