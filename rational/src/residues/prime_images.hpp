#pragma once

// Polynomials with integer coefficients by their images modulo primes.

#include <blossom/rational/integer_polynomials.hpp>

#include <cstdint>
#include <span>
#include <vector>

#include "prime_field.hpp"

namespace blossom {

using WordList = std::vector<std::uint64_t>;

inline constexpr std::uint64_t primes_end = (std::uint64_t{1} << 62) - 1;

/// The greatest prime below an odd number.
std::uint64_t prime_below(std::uint64_t number);

inline WordList words_of(std::span<const Integer> polynomial, const PrimeField& field) {
    WordList words;
    words.reserve(polynomial.size());
    for (const Integer& coefficient : polynomial) words.push_back(field.of(coefficient));
    return words;
}

/// Integers from their residues, with one more prime per step.
class Combination {
public:
    void add(const WordList& words, const PrimeField& field);
    /// The integers of least magnitude with these residues.
    IntegerPolynomial values() const;
    const Integer& modulus() const { return modulus_; }

private:
    IntegerPolynomial values_;
    Integer modulus_ = 1;
};

}  // namespace blossom
