#pragma once

// One blossom value as an expert would write it with FLINT: numerators over a common denominator, the product
// of the linear factors d_i X - a_i by FLINT's own product tree (by plain loops at low degree), its inner
// product with the prepared coefficients, and one reduction. Memory is allocated once, before the timed part.

#include <flint/fmpz_poly.h>

#include "flint_numbers.hpp"

namespace flint_peer {

/// The blossom of a polynomial with coefficients numerators / denominator.
class Polynomial {
public:
    explicit Polynomial(const blossom::RationalVector& coefficients)
        : given_(coefficients.numerators()), prepared_(given_.size()), product_(given_.size()) {
        fmpz_init(given_denominator_);
        fmpz_init(denominator_);
        fmpz_init(binomial_);
        fmpz_init(scale_);
        fmpq_init(value_);
        set(given_denominator_, coefficients.denominator());
    }
    Polynomial(const Polynomial&) = delete;
    Polynomial& operator=(const Polynomial&) = delete;
    ~Polynomial() {
        fmpz_clear(given_denominator_);
        fmpz_clear(denominator_);
        fmpz_clear(binomial_);
        fmpz_clear(scale_);
        fmpq_clear(value_);
    }

    /// (-1)^k c_k / C(n, k) over one denominator in the order of prod (d_i X - a_i), lowest power last.
    void prepare() {
        const slong n = given_.size() - 1;
        fmpz_one(scale_);
        fmpz_one(binomial_);
        for (slong k = 0; k <= n / 2; ++k) {
            fmpz_lcm(scale_, scale_, binomial_);
            fmpz_mul_ui(binomial_, binomial_, static_cast<ulong>(n - k));
            fmpz_divexact_ui(binomial_, binomial_, static_cast<ulong>(k + 1));
        }
        fmpz_one(binomial_);
        for (slong k = 0; k <= n; ++k) {
            fmpz* entry = prepared_.at(n - k);
            fmpz_divexact(entry, scale_, binomial_);
            fmpz_mul(entry, entry, given_.at(k));
            if (k % 2 == 1) fmpz_neg(entry, entry);
            fmpz_mul_ui(binomial_, binomial_, static_cast<ulong>(n - k));
            fmpz_divexact_ui(binomial_, binomial_, static_cast<ulong>(k + 1));
        }
        fmpz_mul(denominator_, scale_, given_denominator_);
    }

    const fmpq* value(const Arguments& arguments) {
        const slong n = arguments.size();
        _fmpz_poly_product_roots_fmpq_vec(product_.data(), arguments.data(), n);
        _fmpz_vec_dot(fmpq_numref(value_), product_.data(), prepared_.data(), n + 1);
        fmpz_mul(fmpq_denref(value_), product_.at(n), denominator_);
        fmpq_canonicalise(value_);
        return value_;
    }

    /// The same with separate denominators: the sum of c_k E_k / C(n, k) by binary splitting of fractions,
    /// where E_k / prod d_i are the elementary symmetric functions.
    const fmpq* value_by_splitting(const Arguments& arguments) {
        const slong n = arguments.size();
        _fmpz_poly_product_roots_fmpq_vec(product_.data(), arguments.data(), n);
        sum_by_splitting(fmpq_numref(value_), fmpq_denref(value_), 0, n + 1);
        fmpz_mul(fmpq_denref(value_), fmpq_denref(value_), product_.at(n));
        fmpz_mul(fmpq_denref(value_), fmpq_denref(value_), given_denominator_);
        fmpq_canonicalise(value_);
        return value_;
    }

    std::string text() const { return text_of(value_); }

private:
    void sum_by_splitting(fmpz_t numerator, fmpz_t denominator, slong begin, slong end) {
        if (end - begin == 1) {
            const slong n = given_.size() - 1;
            fmpz_mul(numerator, given_.at(begin), product_.at(n - begin));
            if (begin % 2 == 1) fmpz_neg(numerator, numerator);
            fmpz_bin_uiui(denominator, static_cast<ulong>(n), static_cast<ulong>(begin));
            return;
        }
        const slong middle = begin + (end - begin) / 2;
        fmpz_t upper;
        fmpz_t upper_denominator;
        fmpz_init(upper);
        fmpz_init(upper_denominator);
        sum_by_splitting(numerator, denominator, begin, middle);
        sum_by_splitting(upper, upper_denominator, middle, end);
        fmpz_mul(numerator, numerator, upper_denominator);
        fmpz_addmul(numerator, upper, denominator);
        fmpz_mul(denominator, denominator, upper_denominator);
        fmpz_clear(upper);
        fmpz_clear(upper_denominator);
    }

    Integers given_;
    Integers prepared_;
    Integers product_;
    fmpz_t given_denominator_;
    fmpz_t denominator_;
    fmpz_t binomial_;
    fmpz_t scale_;
    fmpq_t value_;
};

}  // namespace flint_peer
