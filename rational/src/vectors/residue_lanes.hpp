#pragma once

// Polynomials modulo eight primes at once, one prime a lane. Only what the sources compiled for single
// instruction sets may include: nothing inline from elsewhere, which the linker could take for all.

#include <cstddef>
#include <cstdint>

namespace blossom::residues {

inline constexpr std::size_t lanes = 8;

/// The most terms that one sum takes.
inline constexpr std::size_t most_terms = 4096;
/// The most terms of an operand of `multiply`.
inline constexpr std::size_t most_product_terms = 64;

/// A residue a lane. Residues are below 2 p throughout: which of both values stands for one is left open.
struct alignas(64) Octet {
    std::uint64_t lane[lanes];
};

/// Primes 2^b - delta with what Montgomery's reduction needs, where b = prime_bits of the level, and 2^r the
/// radix, r = radix_bits.
struct Moduli {
    Octet prime;
    Octet delta;    ///< below 2 to the power of delta_bits
    Octet inverse;  ///< 1/p modulo the radix
    Octet radix;    ///< modulo p
    Octet square;   ///< radix^2 modulo p
    Octet root;     ///< a root of unity of order 2^root_order, times the radix
    std::size_t root_order;
};

/// What a level of instruction sets offers.
struct Operations {
    std::size_t prime_bits;
    std::size_t radix_bits;
    std::size_t delta_bits;
    std::size_t root_order;  ///< of as many primes as there are

    /// sum_k a[k] b[k] / radix for k < count <= most_terms.
    Octet (*dot)(const Moduli& moduli, const Octet* a, const Octet* b, std::size_t count);
    /// For each i < count the number with the digits digits[begins[i]..begins[i + 1]), b bits each and at
    /// most most_terms, times power[0] / radix, where the powers are those of 2^b, times that of power[0].
    void (*residues_of_digits)(const Moduli& moduli, const std::uint64_t* digits, const std::size_t* begins,
                               std::size_t count, const Octet* powers, Octet* residues);
    /// The coefficients of the product of a[0..m) and b[0..n), lowest first, divided by the radix;
    /// 1 <= n <= m <= most_product_terms.
    void (*multiply)(const Moduli& moduli, const Octet* a, std::size_t m, const Octet* b, std::size_t n,
                     Octet* product);
    /// a[k] factor / radix.
    void (*scale)(const Moduli& moduli, const Octet* a, const Octet& factor, std::size_t count,
                  Octet* product);
    /// a[k] + b[k] and a[k] - b[k].
    void (*add)(const Moduli& moduli, const Octet* a, const Octet* b, std::size_t count, Octet* sum);
    void (*subtract)(const Moduli& moduli, const Octet* a, const Octet* b, std::size_t count,
                     Octet* difference);
    /// a[k] b[k] / radix.
    void (*multiply_each)(const Moduli& moduli, const Octet* a, const Octet* b, std::size_t count,
                          Octet* product);
    /// The same residues below p.
    void (*reduce)(const Moduli& moduli, Octet* a, std::size_t count);
    /// The values of the polynomial with the coefficients a[0..size) at the powers of a root of unity, where
    /// the indices of the values have their bits in the opposite order, and the inverse but for a division by
    /// `size`, a power of 2. roots[h + i] is power i of a root of order 2 h times the radix, below p, for
    /// i < h < size.
    void (*transform)(const Moduli& moduli, const Octet* roots, Octet* a, std::size_t size);
    void (*inverse_transform)(const Moduli& moduli, const Octet* roots, Octet* a, std::size_t size);
    /// sums[i] += weight / radix * sum_k rows[i][k] (x_i / radix)^(terms-1-k) for i < count, where
    /// x_i = base + offsets[i]. The coefficients in a row are the same for all lanes, and from p to 2 p.
    void (*add_values)(const Moduli& moduli, const std::uint64_t* const* rows, std::size_t terms,
                       const Octet& base, const Octet* offsets, const Octet& weight, std::size_t count,
                       Octet* sums);
};

extern const Operations portable_operations;
extern const Operations avx2_operations;
extern const Operations avx512_operations;

}  // namespace blossom::residues
