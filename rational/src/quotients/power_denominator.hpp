#pragma once

// Denominators that contain powers of numbers with few prime factors in common with the numerators.

#include <blossom/rational/rational.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace blossom {

/// A product > 0 of powers. A reduction takes the gcd, usually 1, of the numerator and each base, not of the
/// numerator and the whole power.
class PowerDenominator {
public:
    /// Multiplies by base^exponent for a base > 0.
    void multiply(const Integer& base, std::size_t exponent);
    /// numerator / product in lowest terms.
    Rational quotient(Integer numerator) const;

private:
    std::vector<std::pair<Integer, std::size_t>> powers_;
    Integer product_ = 1;
};

}  // namespace blossom
