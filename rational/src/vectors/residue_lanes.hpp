#pragma once

// Polynomials modulo eight primes at once, one prime per lane. This header contains only what the sources
// compiled for one instruction set may include: no inline functions, which the linker could choose for the
// whole program.

#include <cstddef>
#include <cstdint>

namespace blossom::residues {

inline constexpr std::size_t lanes = 8;

/// The most terms of one sum.
inline constexpr std::size_t most_terms = 4096;
/// The most terms of an operand of `multiply`.
inline constexpr std::size_t most_product_terms = 64;

/// One residue per lane. Residues are below 2 p, so that each has two representations; either may occur.
struct alignas(64) ResidueVector {
    std::uint64_t lane[lanes];
};

/// Primes 2^b - delta and the constants of Montgomery's reduction, where b = prime_bits of the level, and the
/// radix is 2^r, r = radix_bits.
struct Moduli {
    ResidueVector prime;
    ResidueVector delta;    ///< below 2^delta_bits
    ResidueVector inverse;  ///< 1/p modulo the radix
    ResidueVector radix;    ///< modulo p
    ResidueVector square;   ///< radix^2 modulo p
    ResidueVector root;     ///< a root of unity of order 2^root_order, times the radix
    std::size_t root_order;
};

/// The operations of a level of vector instructions.
struct Operations {
    std::size_t prime_bits;
    std::size_t radix_bits;
    std::size_t delta_bits;
    std::size_t root_order;  ///< for as many primes as possible

    /// sum_k a[k] b[k] / radix for k < count <= most_terms.
    ResidueVector (*dot)(const Moduli& moduli, const ResidueVector* a, const ResidueVector* b,
                         std::size_t count);
    /// For each i < count, the number with the digits digits[begins[i]..begins[i + 1]) of b bits each, at
    /// most most_terms of them, times power[0] / radix. The powers are those of 2^b, times power[0].
    void (*residues_of_digits)(const Moduli& moduli, const std::uint64_t* digits, const std::size_t* begins,
                               std::size_t count, const ResidueVector* powers, ResidueVector* residues);
    /// The coefficients of the product of a[0..m) and b[0..n), lowest first, divided by the radix;
    /// 1 <= n <= m <= most_product_terms.
    void (*multiply)(const Moduli& moduli, const ResidueVector* a, std::size_t m, const ResidueVector* b,
                     std::size_t n, ResidueVector* product);
    /// a[k] factor / radix.
    void (*scale)(const Moduli& moduli, const ResidueVector* a, const ResidueVector& factor,
                  std::size_t count, ResidueVector* product);
    /// a[k] + b[k] and a[k] - b[k].
    void (*add)(const Moduli& moduli, const ResidueVector* a, const ResidueVector* b, std::size_t count,
                ResidueVector* sum);
    void (*subtract)(const Moduli& moduli, const ResidueVector* a, const ResidueVector* b, std::size_t count,
                     ResidueVector* difference);
    /// a[k] b[k] / radix.
    void (*multiply_each)(const Moduli& moduli, const ResidueVector* a, const ResidueVector* b,
                          std::size_t count, ResidueVector* product);
    /// Replaces the residues by the equal ones below p.
    void (*reduce)(const Moduli& moduli, ResidueVector* a, std::size_t count);
    /// `transform` replaces the coefficients a[0..size) of a polynomial by its values at the powers of a root
    /// of unity, in bit-reversed order of their indices; the other function is its inverse, up to a factor
    /// `size`, a power of 2. roots[h + i] is power i of a root of order 2 h times the radix, below p, for i <
    /// h < size.
    void (*transform)(const Moduli& moduli, const ResidueVector* roots, ResidueVector* a, std::size_t size);
    void (*inverse_transform)(const Moduli& moduli, const ResidueVector* roots, ResidueVector* a,
                              std::size_t size);
    /// sums[i] += weight / radix * sum_k rows[i][k] (x_i / radix)^(terms-1-k) for i < count, where x_i = base
    /// + offsets[i]. The coefficients in a row are the same for all lanes, and from p to 2 p.
    void (*add_values)(const Moduli& moduli, const std::uint64_t* const* rows, std::size_t terms,
                       const ResidueVector& base, const ResidueVector* offsets, const ResidueVector& weight,
                       std::size_t count, ResidueVector* sums);
};

extern const Operations portable_operations;
extern const Operations avx2_operations;
extern const Operations avx512_operations;

}  // namespace blossom::residues
