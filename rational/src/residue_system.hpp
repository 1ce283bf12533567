#pragma once

// Integers by their residues modulo groups of eight primes just below 2^50.

#include <blossom/rational/integer.hpp>

#include <memory>
#include <span>
#include <vector>

#include "residue_lanes.hpp"

namespace blossom::residues {

/// The operations for this processor, the first of "ifma" and "portable" that it has and that the environment
/// variable BLOSSOM_VECTOR_LEVEL, if it is set, does not exclude by naming another.
const Operations& operations();

/// Group i of the primes, the same for the whole life of the program.
const Moduli& moduli(std::size_t group);

/// As many groups as determine an integer of at most `bits` bits and its sign.
constexpr std::size_t groups_for(std::size_t bits) {
    // A prime is above 2^50 (1 - 2^-26), so that fewer than 2^25 of them have a product above 2^(50 k - 1).
    const std::size_t primes = (bits + 3 + 49) / 50;
    return (primes + lanes - 1) / lanes;
}

/// Integers as magnitudes in digits of 50 bits.
class Digits {
public:
    void reserve(std::size_t values);
    void push_back(std::int64_t value);
    void push_back(const Integer& value);
    std::size_t size() const { return negative_.size(); }
    std::size_t most_digits() const { return most_digits_; }
    /// All values, if they were given as words and nothing else.
    const std::vector<std::int64_t>* words() const { return words_.size() == size() ? &words_ : nullptr; }
    /// Value i modulo the primes: times 2^52 if the powers are those of `montgomery_powers`.
    Octet residues(std::size_t i, const Moduli& moduli, const Octet* powers) const;

private:
    void finish(bool negative);

    std::vector<std::int64_t> words_;
    std::vector<std::uint64_t> digits_;
    std::vector<std::size_t> begins_{0};
    std::vector<bool> negative_;
    std::size_t most_digits_ = 0;
};

/// 2^(50 k) for k < count, times 2^52 or, for residues in Montgomery's form, times 2^104.
std::vector<Octet> plain_powers(const Moduli& moduli, std::size_t count);
std::vector<Octet> montgomery_powers(const Moduli& moduli, std::size_t count);

/// The integer of least magnitude with these residues, one octet a group. Its tables are kept for the numbers
/// of groups met last.
Integer integer_with(std::span<const Octet> residues);

}  // namespace blossom::residues
