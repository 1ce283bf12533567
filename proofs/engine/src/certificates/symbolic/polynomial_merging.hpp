#pragma once

#include "polynomial_parts.hpp"

namespace blossom::proofs::second {

/// The numerators of a polynomial times a monomial and an integer. The shift has the same width as the terms.
struct ShiftedTerms {
    const PlainPolynomial& terms;
    const std::uint64_t* shift;
    const Integer& factor;
};

/// The sum of two shifted lists of terms with one layout, over the denominator 1. The caller sets the bound
/// on the exponents.
PlainPolynomial merged_terms(const ShiftedTerms& a, const ShiftedTerms& b, Budget& budget);

}  // namespace blossom::proofs::second
