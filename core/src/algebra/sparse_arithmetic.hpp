#pragma once

#include <blossom/core/algebra/sparse_polynomial.hpp>

#include <algorithm>
#include <utility>

#include "packed_monomials.hpp"

namespace blossom {

/// The layout of the monomials of a polynomial in words.
struct SparseLayout {
    std::size_t variables = 0;
    std::size_t bits = packed_monomials::least_bits;

    std::size_t words() const { return packed_monomials::words_for(variables, bits); }
};

/// Terms with integer coefficients, in order and without zeros, all with the same layout.
struct SparseTerms {
    std::vector<std::uint64_t> monomials;
    std::vector<Integer> coefficients;

    std::size_t size() const { return coefficients.size(); }
};

/// Access to the representation for the arithmetic of sparse polynomials.
struct SparseArithmetic {
    static SparseLayout layout(const SparsePolynomial& a) { return {a.variables_, a.bits_}; }
    static SparseLayout common_layout(const SparseLayout& a, const SparseLayout& b) {
        return {std::max(a.variables, b.variables), std::max(a.bits, b.bits)};
    }

    /// The greatest exponent of each variable, as a monomial in the layout of the polynomial.
    static std::vector<std::uint64_t> degrees(const SparsePolynomial& a) {
        return packed_monomials::greatest_exponents(a.monomials_, a.words_, a.bits_);
    }

    [[noreturn]] static void exponent_too_large();

    static const std::vector<std::uint64_t>& monomials(const SparsePolynomial& a) { return a.monomials_; }

    /// The polynomial with these terms over a denominator, in its canonical form.
    static SparsePolynomial polynomial(SparseTerms terms, const SparseLayout& layout, Integer denominator);

private:
    static void shrink(SparsePolynomial& polynomial);
};

/// The terms of a polynomial in another layout; not copied if the layout is the same.
class AlignedTerms {
public:
    AlignedTerms(const SparsePolynomial& polynomial, const SparseLayout& layout) : polynomial_(&polynomial) {
        const SparseLayout own = SparseArithmetic::layout(polynomial);
        if (own.bits == layout.bits && own.words() == layout.words()) return;
        rewritten_ = packed_monomials::rewritten(SparseArithmetic::monomials(polynomial), own.words(),
                                                 own.bits, layout.words(), layout.bits);
        if (own.words() == 0) rewritten_.resize(polynomial.size() * layout.words());
    }

    std::size_t size() const { return polynomial_->size(); }
    const std::uint64_t* monomials() const {
        return rewritten_.empty() ? SparseArithmetic::monomials(*polynomial_).data() : rewritten_.data();
    }
    const Integer* coefficients() const { return polynomial_->coefficients().numerators().data(); }

private:
    const SparsePolynomial* polynomial_;
    std::vector<std::uint64_t> rewritten_;
};

}  // namespace blossom
