#include "power_denominator.hpp"

#include "number/rational_access.hpp"

namespace blossom {

namespace {

/// The part of `base` with the primes of `common`, a divisor of it.
Integer part_with_primes(const Integer& base, Integer common) {
    Integer part = common;
    Integer rest = divide_exactly(base, common);
    while (!rest.is_one()) {
        common = gcd(rest, common);
        if (common.is_one()) break;
        part *= common;
        rest = divide_exactly(rest, common);
    }
    return part;
}

}  // namespace

void PowerDenominator::multiply(const Integer& base, std::size_t exponent) {
    if (base.is_one() || exponent == 0) return;
    powers_.emplace_back(base, exponent);
    product_ *= pow(base, exponent);
}

Rational PowerDenominator::quotient(const Integer& numerator) const {
    if (numerator.is_zero()) return {};
    Integer suspected = 1;
    for (const auto& [base, exponent] : powers_) {
        const Integer common = gcd(numerator, base);
        if (!common.is_one()) suspected *= pow(part_with_primes(base, common), exponent);
    }
    const Integer common = suspected.is_one() ? suspected : gcd(numerator, suspected);
    if (common.is_one()) return RationalAccess::from_lowest_terms(numerator, product_);
    return RationalAccess::from_lowest_terms(divide_exactly(numerator, common),
                                             divide_exactly(product_, common));
}

}  // namespace blossom
