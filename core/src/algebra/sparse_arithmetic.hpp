#pragma once

#include <blossom/core/algebra/sparse_polynomial.hpp>

#include <algorithm>
#include <utility>

#include "packed_monomials.hpp"

namespace blossom {

/// What the arithmetic of sparse polynomials works on: terms with integer coefficients, in order and without
/// zeros, all with one layout.
struct SparseArithmetic {
    struct Layout {
        std::size_t variables = 0;
        std::size_t bits = packed_monomials::least_bits;

        std::size_t words() const { return packed_monomials::words_for(variables, bits); }
    };

    struct Terms {
        std::vector<std::uint64_t> monomials;
        std::vector<Integer> coefficients;

        std::size_t size() const { return coefficients.size(); }
    };

    /// The terms of a polynomial with monomials of another layout, in place where it is the same one.
    class Aligned {
    public:
        Aligned(const SparsePolynomial& polynomial, const Layout& layout) : polynomial_(&polynomial) {
            if (polynomial.bits_ == layout.bits && polynomial.words_ == layout.words()) return;
            rewritten_ = packed_monomials::rewritten(polynomial.monomials_, polynomial.words_,
                                                     polynomial.bits_, layout.words(), layout.bits);
            if (polynomial.words_ == 0) rewritten_.resize(polynomial.size() * layout.words());
        }

        std::size_t size() const { return polynomial_->size(); }
        const std::uint64_t* monomials() const {
            return rewritten_.empty() ? polynomial_->monomials_.data() : rewritten_.data();
        }
        const Integer* coefficients() const { return polynomial_->coefficients_.numerators().data(); }

    private:
        const SparsePolynomial* polynomial_;
        std::vector<std::uint64_t> rewritten_;
    };

    static Layout layout(const SparsePolynomial& a) { return {a.variables_, a.bits_}; }
    static Layout common_layout(const Layout& a, const Layout& b) {
        return {std::max(a.variables, b.variables), std::max(a.bits, b.bits)};
    }

    /// The greatest exponent of each variable, as a monomial in the layout of the polynomial.
    static std::vector<std::uint64_t> degrees(const SparsePolynomial& a) {
        return packed_monomials::greatest_exponents(a.monomials_, a.words_, a.bits_);
    }

    [[noreturn]] static void exponent_too_large();

    static const std::vector<std::uint64_t>& monomials(const SparsePolynomial& a) { return a.monomials_; }

    /// The polynomial with these terms over a denominator, in its canonical form.
    static SparsePolynomial polynomial(Terms terms, const Layout& layout, Integer denominator);

private:
    static void shrink(SparsePolynomial& polynomial);
};

}  // namespace blossom
