#pragma once

#include <blossom/rational/rational.hpp>

#include <cstddef>
#include <map>

/// The arithmetic of the checker of certificates: polynomials as maps from exponents to numbers, and
/// quotients of them. Slow and plain on purpose, and apart from the polynomials of the prover.

namespace blossom::cli::proof_terms {

using Monomial = std::map<std::size_t, std::size_t>;  ///< exponents by symbol, none of them 0
using Terms = std::map<Monomial, Rational>;           ///< none of them 0

/// to += factor * from
void add(Terms& to, const Terms& from, const Rational& factor = 1);
/// Cost: one product for each pair of terms.
Terms times(const Terms& a, const Terms& b);
/// The constant.
Terms number(const Rational& value);
Terms power(const Terms& base, std::size_t exponent);

/// Terms over a product of powers of other terms.
struct Quotient {
    Terms numerator;
    std::map<Terms, std::size_t> divisors;
};

Quotient product_of(const Quotient& a, const Quotient& b);
/// Over the least common multiple of the divisors as they are written.
Quotient sum_of(const Quotient& a, const Quotient& b);
Quotient negated(Quotient value);
/// a / b. The caller guarantees that b is not zero.
Quotient quotient_of(const Quotient& a, const Quotient& b);

}  // namespace blossom::cli::proof_terms
