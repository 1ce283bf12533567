#pragma once

// Denominators with powers of numbers that have few primes in common with numerators.

#include <blossom/rational/rational.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace blossom {

/// A product > 0 of powers. Only the gcds of a numerator and each base are taken, mostly 1, and not those of
/// the numerator and whole powers.
class PowerDenominator {
public:
    /// By base^exponent for a base > 0.
    void multiply(const Integer& base, std::size_t exponent);
    /// numerator / product in lowest terms.
    Rational quotient(Integer numerator) const;

private:
    std::vector<std::pair<Integer, std::size_t>> powers_;
    Integer product_ = 1;
};

}  // namespace blossom
