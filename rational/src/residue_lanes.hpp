#pragma once

// Polynomials modulo eight primes at once, one prime a lane. Only what the sources compiled for single
// instruction sets may include: nothing inline from elsewhere, which the linker could take for all.

#include <cstddef>
#include <cstdint>

namespace blossom::residues {

inline constexpr std::size_t lanes = 8;

/// The most products that one sum takes: of 2^52 each, they stay below 2^64.
inline constexpr std::size_t most_terms = 4096;
/// The lower 50 bits: a prime is below 2^50.
inline constexpr std::uint64_t low_50 = (std::uint64_t{1} << 50) - 1;

/// A residue a lane.
struct alignas(64) Octet {
    std::uint64_t lane[lanes];
};

/// Primes 2^50 - delta with what Montgomery's reduction modulo 2^52 needs. All residues here stand for
/// themselves times 2^52.
struct Moduli {
    Octet prime;
    Octet delta;             ///< below 2^24
    Octet negative_inverse;  ///< -1/p modulo 2^52
    Octet square;            ///< 2^104 modulo p
};

/// What a level of instruction sets offers; all give the same results.
struct Operations {
    /// sum_k a[k] b[k] / 2^52 for k < count <= most_terms.
    Octet (*dot)(const Moduli& moduli, const Octet* a, const Octet* b, std::size_t count);
    /// sum_k digits[k] powers[k] / 2^52 for digits below 2^52, the same in all lanes.
    Octet (*digit_dot)(const Moduli& moduli, const std::uint64_t* digits, const Octet* powers,
                       std::size_t count);
    /// Words times 2^52, where `powers` are 1 and 2^50 times 2^104.
    void (*residues_of_words)(const Moduli& moduli, const std::int64_t* words, std::size_t count,
                              const Octet* powers, Octet* residues);
    /// The coefficients of the product of the factors factors[2 i] + factors[2 i + 1] X, i < count, with one
    /// division by 2^52 for each factor but the first.
    void (*multiply_linear)(const Moduli& moduli, const Octet* factors, std::size_t count, Octet* product);
    /// The coefficients of the product of a[0..m] and b[0..n], lowest first, m >= n; divided by 2^52.
    void (*multiply)(const Moduli& moduli, const Octet* a, std::size_t m, const Octet* b, std::size_t n,
                     Octet* product);
};

extern const Operations portable_operations;
#if defined(BLOSSOM_AVX512_IFMA)
extern const Operations ifma_operations;
#endif

}  // namespace blossom::residues
