#include "sparse_arithmetic.hpp"

#include <blossom/rational/error.hpp>

#include <string>

namespace blossom {

void SparseArithmetic::exponent_too_large() {
    throw Error(ErrorCode::limit_exceeded, "an exponent exceeds the limit " +
                                               std::to_string(packed_monomials::greatest_exponent) +
                                               " of a symbolic polynomial");
}

SparsePolynomial SparseArithmetic::polynomial(SparseTerms terms, const SparseLayout& layout,
                                              Integer denominator) {
    SparsePolynomial result;
    if (terms.size() == 0) return result;
    if (2 * terms.size() < terms.coefficients.capacity()) {
        terms.monomials.shrink_to_fit();
        terms.coefficients.shrink_to_fit();
    }
    result.variables_ = layout.variables;
    result.bits_ = layout.bits;
    result.words_ = layout.words();
    result.monomials_ = std::move(terms.monomials);
    result.coefficients_ = RationalVector(std::move(terms.coefficients), std::move(denominator));
    result.coefficients_.make_canonical();
    shrink(result);
    return result;
}

/// Drops variables that do not occur, and bits that no exponent needs. Cost: if nothing can be dropped, up to
/// the first terms that need everything.
void SparseArithmetic::shrink(SparsePolynomial& polynomial) {
    const std::size_t words = polynomial.words_;
    if (words == 0) return;
    const std::size_t bits = polynomial.bits_;
    const std::uint64_t large =
        packed_monomials::guards(bits) - (packed_monomials::ones(bits) << (bits / 2 - 1));
    const std::size_t last = (polynomial.variables_ - 1) * bits % 64;
    const std::uint64_t last_variable = (~std::uint64_t{0} >> (64 - bits)) << (64 - bits - last);
    bool needs_bits = bits == packed_monomials::least_bits;
    bool needs_variables = false;
    for (std::size_t i = 0; i < polynomial.monomials_.size() && !(needs_bits && needs_variables);
         i += words) {
        needs_variables = needs_variables || (polynomial.monomials_[i + words - 1] & last_variable) != 0;
        for (std::size_t j = 0; j < words && !needs_bits; ++j)
            needs_bits = (polynomial.monomials_[i + j] & large) != 0;
    }
    if (needs_bits && needs_variables) return;

    const std::vector<std::uint64_t> greatest = degrees(polynomial);
    SparseLayout layout{polynomial.variables_, bits};
    while (layout.variables > 0 && packed_monomials::exponent(greatest, layout.variables - 1, bits) == 0)
        --layout.variables;
    std::size_t exponent = 0;
    for (std::size_t k = 0; k < layout.variables; ++k)
        exponent = std::max(exponent, packed_monomials::exponent(greatest, k, bits));
    layout.bits = packed_monomials::bits_for(exponent);
    if (layout.words() != words || layout.bits != bits) {
        polynomial.monomials_ =
            packed_monomials::rewritten(polynomial.monomials_, words, bits, layout.words(), layout.bits);
    }
    polynomial.variables_ = layout.variables;
    polynomial.bits_ = layout.bits;
    polynomial.words_ = layout.words();
}

}  // namespace blossom
