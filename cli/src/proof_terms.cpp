#include "proof_terms.hpp"

#include <algorithm>

namespace blossom::cli::proof_terms {

void add(Terms& to, const Terms& from, const Rational& factor) {
    for (const auto& [monomial, coefficient] : from) {
        Rational& sum = to[monomial];
        sum += factor * coefficient;
        if (sum.is_zero()) to.erase(monomial);
    }
}

Terms times(const Terms& a, const Terms& b) {
    Terms product;
    for (const auto& [monomial, coefficient] : a) {
        for (const auto& [other, factor] : b) {
            Monomial both = monomial;
            for (const auto& [symbol, exponent] : other) both[symbol] += exponent;
            Rational& sum = product[both];
            sum += coefficient * factor;
            if (sum.is_zero()) product.erase(both);
        }
    }
    return product;
}

Terms number(const Rational& value) { return value.is_zero() ? Terms{} : Terms{{Monomial{}, value}}; }

Terms power(const Terms& base, std::size_t exponent) {
    Terms result = number(1);
    for (std::size_t i = 0; i < exponent; ++i) result = times(result, base);
    return result;
}

namespace {

Terms multiplied_out(const std::map<Terms, std::size_t>& divisors) {
    Terms product = number(1);
    for (const auto& [divisor, exponent] : divisors) product = times(product, power(divisor, exponent));
    return product;
}

}  // namespace

Quotient product_of(const Quotient& a, const Quotient& b) {
    Quotient result{times(a.numerator, b.numerator), a.divisors};
    for (const auto& [divisor, exponent] : b.divisors) result.divisors[divisor] += exponent;
    return result;
}

Quotient sum_of(const Quotient& a, const Quotient& b) {
    Quotient result;
    result.divisors = a.divisors;
    for (const auto& [divisor, exponent] : b.divisors) {
        std::size_t& greatest = result.divisors[divisor];
        greatest = std::max(greatest, exponent);
    }
    for (const Quotient* summand : {&a, &b}) {
        std::map<Terms, std::size_t> missing = result.divisors;
        for (const auto& [divisor, exponent] : summand->divisors) missing[divisor] -= exponent;
        add(result.numerator, times(summand->numerator, multiplied_out(missing)));
    }
    return result;
}

Quotient negated(Quotient value) {
    for (auto& [monomial, coefficient] : value.numerator) coefficient = -coefficient;
    return value;
}

Quotient quotient_of(const Quotient& a, const Quotient& b) {
    return product_of(a, {multiplied_out(b.divisors), {{b.numerator, 1}}});
}

}  // namespace blossom::cli::proof_terms
