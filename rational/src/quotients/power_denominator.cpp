#include "power_denominator.hpp"

#include <utility>

#include "number/rational_access.hpp"

namespace blossom {

void PowerDenominator::multiply(const Integer& base, std::size_t exponent) {
    if (base.is_one() || exponent == 0) return;
    powers_.emplace_back(base, exponent);
    product_ *= pow(base, exponent);
}

// With g = gcd(N, base), N / g and base / g are coprime, so that one gcd settles each factor `base`; once it
// is 1, it settles all remaining ones.
Rational PowerDenominator::quotient(Integer numerator) const {
    if (numerator.is_zero()) return {};
    Integer shared = 1;
    for (const auto& [base, exponent] : powers_) {
        for (std::size_t i = 0; i < exponent; ++i) {
            const Integer common = gcd(numerator, base);
            if (common.is_one()) break;
            numerator = divide_exactly(numerator, common);
            shared *= common;
        }
    }
    return RationalAccess::from_lowest_terms(std::move(numerator),
                                             shared.is_one() ? product_ : divide_exactly(product_, shared));
}

}  // namespace blossom
