#pragma once

#include "polynomial_parts.hpp"

namespace blossom::proofs::second {

/// The numerators of a polynomial times a monomial and an integer. The shift has the width of the terms.
struct ShiftedTerms {
    const PlainPolynomial& terms;
    const std::uint64_t* shift;
    const Integer& factor;
};

/// The sum of two such, over the denominator 1, from terms of one layout. The bound of the exponents is left
/// to the caller.
PlainPolynomial merged_terms(const ShiftedTerms& a, const ShiftedTerms& b, Budget& budget);

}  // namespace blossom::proofs::second
