#pragma once

// Denominators with powers of numbers that have few primes in common with numerators.

#include <blossom/rational/rational.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace blossom {

/// A product > 0 of powers. A prime that divides a numerator N and a power divides gcd(N, base), mostly 1, so
/// that the gcd of N and the power itself is not needed.
class PowerDenominator {
public:
    /// By base^exponent for a base > 0.
    void multiply(const Integer& base, std::size_t exponent);
    /// numerator / product in lowest terms.
    Rational quotient(const Integer& numerator) const;

private:
    std::vector<std::pair<Integer, std::size_t>> powers_;
    Integer product_ = 1;
};

}  // namespace blossom
