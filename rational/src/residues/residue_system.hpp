#pragma once

// Residues of integers modulo groups of eight primes.

#include <blossom/rational/integer.hpp>

#include <memory>
#include <span>
#include <vector>

#include "number/uint128.hpp"
#include "vectors/vector_table.hpp"

namespace blossom::residues {

inline const Operations& operations() { return *vectors::table().residues; }

/// Group i of the primes; it never changes while the program runs.
const Moduli& moduli(std::size_t group);

/// The least number of groups that determines an integer of at most `bits` bits and its sign.
std::size_t groups_for(std::size_t bits);

/// The most bits of an integer for which there are enough primes.
inline constexpr std::size_t most_bits = 2'000'000;

/// Integers as magnitudes in digits of as many bits as the primes have.
class Digits {
public:
    void reserve(std::size_t values, std::size_t digits_of_one);
    void push_back(Int128 value);
    void push_back(const Integer& value);
    std::size_t size() const { return negative_.size(); }
    std::size_t most_digits() const { return most_digits_; }
    /// The residues of all values modulo the primes; times the radix if the powers are those of
    /// `montgomery_powers`.
    void residues(const Moduli& moduli, const ResidueVector* powers, ResidueVector* residues) const;

private:
    void finish(bool negative);

    std::vector<std::uint64_t> words_;  ///< the words of one value while it is split
    std::vector<std::uint64_t> digits_;
    std::vector<std::size_t> begins_{0};
    std::vector<std::uint8_t> negative_;
    std::size_t most_digits_ = 0;
};

/// 2^(b k) for k < count and primes of b bits, times the radix, or times its square for residues in
/// Montgomery's form.
std::vector<ResidueVector> plain_powers(const Moduli& moduli, std::size_t count);
std::vector<ResidueVector> montgomery_powers(const Moduli& moduli, std::size_t count);

/// The integer of least magnitude with these residues, one vector per group. The tables for the most recent
/// numbers of groups are kept.
Integer integer_with(std::span<const ResidueVector> residues);

}  // namespace blossom::residues
